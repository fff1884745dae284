// What every chapter from here on stands on: models through this chapter's loaders, and the camera's matrix.
#pragma once
#include "01_obj/exercises.h"
#include "01_obj/obj.h"
#include "common/app/chapter.h"

namespace lightwalk {

class ModelChapter : public Chapter {
  public:
    Model load_model(const std::filesystem::path& file) override { return lightwalk::load_model(file, loader()); }

    bool animated() const override { return scene.moves(); }

  protected:
    /// Which loader reads .obj files.
    virtual Loader loader() const { return Loader::parallel; }

    // [view]
    /// Places what moves, and gives the shaders of this frame the uniform block `view`.
    void set_view(Frame& frame) {
        animate(scene, frame.time_s);
        scene.upload_moved(frame);
        const float aspect = static_cast<float>(frame.size.x) / static_cast<float>(frame.size.y);
        const CameraView view{.view_projection = view_projection(camera, aspect),
                              .eye = camera.position,
                              .time_s = frame.time_s,
                              .size = frame.size,
                              .seed = frame.seed};
        const auto bytes = std::as_bytes(std::span(&view, 1));
        frame.globals["view"].assign(bytes.begin(), bytes.end());
    }
    // [/view]
};

}  // namespace lightwalk
