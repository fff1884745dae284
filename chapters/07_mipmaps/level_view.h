// Viewer of one texture level, magnified, beside the exact level and the difference.
#pragma once
#include "07_mipmaps/mip_chain.h"
#include "07_mipmaps/texels.h"
#include "common/app/module.h"
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

struct LevelView : Module {
    LevelView(Module& owner, std::string name) : Module(owner, std::move(name), "viewer") {}

    Knob<int> texture{*this,
                      "texture",
                      0,
                      {0, 63},
                      "Texture to show: index among the textures of the scene; beyond the last, the last one"};
    Knob<int> level{*this, "level", 4, {0, 14}, "Level to show: 0 is the full size; beyond the last, the last one"};
    Knob<float> gain{*this, "gain", 8.0f, {1.0f, 255.0f}, "Scale factor for the displayed difference of codes"};

    /// Draws three pictures into frame.hdr: the level as it is, the exact mean, the difference. Their codes are shown
    /// as colours.
    void record(Frame& frame, const LevelledMaps& maps, const MipChain& chain);

    /// Caption: "ceramic_albedo.jpg, diffuse: level 4, 32x32".
    const std::string& text() const { return text_; }

  private:
    Pipeline show_ = compute({.shader = "07_mipmaps/level_view.comp"});
    const LevelledMaps::Entry* shown_ = nullptr;  ///< key of exact_
    uint32_t shown_level_ = 0;
    Image exact_;
    std::string text_;
};

}  // namespace lightwalk
