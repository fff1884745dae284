// One level of a texture, magnified, beside the exact one and the difference.
#pragma once
#include "07_mipmaps/levelled_maps.h"
#include "07_mipmaps/texels.h"
#include "common/app/module.h"

namespace lightwalk {

struct LevelView : Module {
    LevelView(Module& owner, std::string name) : Module(owner, std::move(name), "viewer") {}

    Knob<int> texture{*this, "texture", 0, {0, 63}, "which of the scene's textures; the last where there are fewer"};
    Knob<int> level{*this, "level", 4, {0, 14}, "which level; the last where there are fewer"};
    Knob<float> gain{*this, "gain", 8.0f, {1.0f, 255.0f}, "by what the difference of codes is multiplied"};

    /// Draws three pictures into frame.hdr: the level as it is, the exact mean, the difference. Their codes are shown
    /// as colours.
    void record(Frame& frame, const LevelledMaps& maps, const MipChain& chain);

    /// What is shown: "ceramic_albedo.jpg, diffuse: level 4, 32x32".
    const std::string& text() const { return text_; }

  private:
    Pipeline show_ = compute({.shader = "07_mipmaps/level_view.comp"});
    const LevelledMaps::Entry* shown_ = nullptr;  ///< whose exact level is in exact_
    uint32_t shown_level_ = 0;
    Image exact_;
    std::string text_;
};

}  // namespace lightwalk
