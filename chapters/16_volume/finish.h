// Surfaces of the rings: maps by code, and occlusion baked by rays.
#pragma once
#include "05_shadow_maps/rays.h"
#include "16_volume/lathe.h"

namespace lightwalk {

// [finish]
/// Gives every item made from a .lathe file its maps: albedo, coloured highlights, gloss, the exemption map (glowing
/// parts receive no light), and ambient occlusion. Occlusion is baked by rays against the item alone, since others
/// turn; kept in the cache, and written there whole or not at all. Must be prepared before chapter 04's maps are.
struct Finish : Module {
    Finish(Module& owner, std::string name) : Module(owner, std::move(name), "finish") {}

    Knob<int> width{*this, "width", 2048, {64, 4096}, "Width of the maps, in texels; they are an eighth as high."};
    Knob<int> bake_rays{*this, "bake_rays", 48, {1, 256}, "Rays per texel of the baked occlusion"};
    Knob<float> bake_m{
        *this, "bake_m", 1.0f, {0.01f, 1000.0f}, "Length of these rays: what is farther away occludes nothing", "m"};

    bool load_proxy(const std::filesystem::path& file, Model& into) const override {
        if (!is_lathe_file(file)) return false;
        const Lathe lathe = read_lathe(file);
        into = lathe_model(lathe, turn_lathe(lathe));
        return true;
    }
    void prepare(Gpu& gpu, Scene& scene) override;
    std::string load_key() const override { return width.text() + " " + bake_rays.text() + " " + bake_m.text(); }
    // [/finish]

    /// For tests: how many maps of occlusion were computed, and not found in the cache.
    int baked = 0;

  private:
    struct Maps {
        std::shared_ptr<Image> diffuse, specular, emissive, gloss, occlusion;
    };
    Maps make(Gpu& gpu, const std::filesystem::path& file);
    std::vector<std::byte> occlusion(Gpu& gpu, const std::filesystem::path& file, const LatheParts& parts,
                                     glm::uvec2 size);
    std::vector<std::byte> bake(Gpu& gpu, const std::filesystem::path& file, const LatheParts& parts, glm::uvec2 size);
    SceneRays rays_{*this, "rays"};
    Pipeline bake_ = compute({.shader = "16_volume/bake.comp"});
};

}  // namespace lightwalk
