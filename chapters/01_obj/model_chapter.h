// Base of every chapter from here on: models read by this chapter's loaders, and the camera's matrix.
#pragma once
#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "common/app/chapter.h"
#include "common/app/render.h"

namespace lightwalk {

/// Interpretation of ambiguous material files.
struct MtlReading : Module {
    using Module::Module;
    Choice tr{*this,
              "tr",
              {"safe", "transparency", "opacity"},
              "safe",
              "Meaning of Tr without d in material files: transparency, opacity, or transparency unless the whole "
              "material would vanish (safe)"};
    std::string load_key() const override { return tr.text(); }
};

class ModelChapter : public Chapter {
  public:
    MtlReading mtl{*this, "mtl"};

    Model load_model(const std::filesystem::path& file) override;
    std::vector<std::string> load_exercises() const override;

  protected:
    /// Which loader reads .obj files.
    virtual Loader loader() const { return Loader::parallel; }

    /// Places moving objects, and sets this frame's uniform block `view`, the camera's view.
    View set_view(Frame& frame) { return set_view(frame, camera); }
    View set_view(Frame& frame, const Camera& from);
    View set_view(Frame& frame, World& world) { return look_at(world, frame, scene, camera); }
};

}  // namespace lightwalk
