// Scene textures with levels rebuilt in every frame, as for changing textures.
#pragma once
#include "07_mipmaps/mip_chain.h"
#include "common/scene/scene.h"

namespace lightwalk {

class LevelledMaps : public Module {
  public:
    using Module::Module;

    struct Entry {
        std::string name;
        Content content;
        Image plain, levels;  ///< its first level alone, and with room for all
    };

    /// Copies the scene's textures, with the content type of each slot. Waits.
    void prepare(Gpu& gpu, Scene& scene) override;
    std::vector<std::string> load_exercises() const override { return {"07.level_sizes"}; }

    /// Records the levels of every texture.
    void record(Frame& frame, MipChain& chain, float cutoff);
    /// Whether they were recorded since prepare(): until then all but the first are black.
    bool recorded() const { return recorded_; }

    /// Makes the scene draw with levels, or with the first alone; until the next call.
    void use(Scene& scene, bool levels) const;

    /// Reads of a pass that draws the scene.
    std::vector<Resource> reads() const override;

    const std::vector<std::shared_ptr<Entry>>& entries() const { return entries_; }

  private:
    struct Use {
        uint32_t item;
        size_t slot;
        std::shared_ptr<Entry> entry;
    };
    std::vector<std::shared_ptr<Entry>> entries_;
    std::vector<Use> uses_;
    bool recorded_ = false;
};

}  // namespace lightwalk
