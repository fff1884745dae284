// A model that was read beside the picture, on its way to the device.
#pragma once
#include "18_playground/background_load.h"
#include "common/gpu/slices.h"

namespace lightwalk {

// [arrival]
/// Uploads a model read by a thread, a few milliseconds per frame, and gives it to a scene's pools, where loading
/// then finds it complete.
class Arrival {
  public:
    Arrival(Gpu& gpu, std::filesystem::path file, LoadedModel read);
    Arrival(const Arrival&) = delete;  // the slices know where everything is

    bool step(double budget_ms) { return slices_.step(gpu_, budget_ms); }  ///< true: all of it is there
    float share() const { return slices_.share(); }
    void give(Scene& scene) const;
    const Model& model() const { return model_->model; }
    // [/arrival]

  private:
    Gpu& gpu_;
    std::filesystem::path file_;
    LoadedModel read_;
    std::shared_ptr<GpuModel> model_ = std::make_shared<GpuModel>();
    struct Texture {
        std::shared_ptr<Image> image, normals;
    };
    std::vector<Texture> textures_;  ///< of read_.textures
    Slices slices_;
};

}  // namespace lightwalk
