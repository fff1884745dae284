// A model that is read on a thread beside the picture.
#pragma once
#include <future>
#include <memory>
#include <optional>

#include "common/base/progress.h"
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

// [background_load]
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
                                // [/background_load]

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
