// What every chapter from here on stands on: models through this chapter's loaders, and the camera's matrix.
#pragma once
#include "01_obj/exercises.h"
#include "01_obj/obj.h"
#include "common/app/chapter.h"
#include "common/app/render.h"
#include "common/scene/view.h"

namespace lightwalk {

class ModelChapter : public Chapter {
  public:
    Model load_model(const std::filesystem::path& file) override { return lightwalk::load_model(file, loader()); }

    bool animated() const override { return scene.moves(); }

  protected:
    /// Which loader reads .obj files.
    virtual Loader loader() const { return Loader::parallel; }

    // [view]
    /// Places what moves, and gives the shaders of this frame the uniform block `view`: what the camera sees.
    void set_view(Frame& frame) {
        animate(scene, frame.time_s);
        scene.upload_moved(frame);
        const glm::vec2 whole(frame.crop.whole);
        look_from({part_of(frame.crop, frame.size) * view_projection(camera, whole.x / whole.y), camera.position},
                  frame);
    }
    // [/view]
};

}  // namespace lightwalk
