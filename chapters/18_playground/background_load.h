// A model that is read on a thread beside the picture, and uploaded in slices.
#pragma once
#include <future>
#include <memory>
#include <optional>

#include "common/base/progress.h"
#include "common/gpu/slices.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// A texture named by the model's materials; for a normal map also chapter 04's derived images.
struct LoadedTexture {
    TextureUse use;
    DecodedTexture texels;
    std::vector<std::vector<std::byte>> normal_levels;
};

/// A model with chapter 04's derived data and its textures; unreadable ones are omitted.
struct LoadedModel {
    Model model;
    std::vector<std::vector<TangentFrame>> frames;  ///< of each mesh
    std::vector<LoadedTexture> textures;
};

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

/// One model at a time. Reading, joining vertices, tangents and decoding textures are work for the processor, and run
/// on threads that give way to the window's; only that one speaks to the device.
class BackgroundLoad {
  public:
    ~BackgroundLoad() { cancel(); }

    /// Replaces the load in progress.
    void start(const std::filesystem::path& file);
    /// Immediate: the thread ends at its next report, and its result is discarded.
    void cancel();
    bool busy() const { return now_.has_value(); }

    struct Ended {
        std::filesystem::path file;
        std::optional<LoadedModel> model;  ///< none: it failed, and `error` says why
        std::string error;
    };
    std::optional<Ended> poll();  ///< once for each

    float share() const;        ///< of the stage that words() names, 0 to 1
    std::string words() const;  ///< "dragon.obj: reading 43%"

  private:
    struct Now {
        std::filesystem::path file;
        std::shared_ptr<Progress> progress;
        std::future<LoadedModel> read;
    };
    std::optional<Now> now_;
    std::vector<std::future<LoadedModel>> dropped_;
};

}  // namespace lightwalk
