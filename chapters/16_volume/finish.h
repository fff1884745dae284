// Surfaces of the rings: maps by code, and occlusion baked by rays.
#pragma once
#include <filesystem>
#include <vector>

#include "05_shadow_maps/rays.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// Contents of a .lathe file: JSON with these keys.
struct Lathe {
    std::vector<glm::vec2> profile;  ///< distance from the axis and height, metres; its right-hand side is outside
    std::vector<int> rows;           ///< of panels along each part of the profile
    bool closed = true;              ///< the last point is joined to the first
    int columns = 160;               ///< cells around the axis, 8 to 1024
    int longest = 5;                 ///< most cells that a panel spans, 1 to 32
    float relief_m = 0.01f;          ///< how far panels stand out or lie in, at most
    float bevel_m = 0.006f;          ///< width of their slanted edges
    float glow = 0.05f;              ///< share of panels with glowing squares, 0 to 1
    int seed = 1;
    glm::vec3 albedo{0.3f}, second{0.2f};             ///< linear; of two kinds of panels
    glm::vec3 specular{0.3f}, second_specular{0.5f};  ///< linear
    glm::vec3 glow_color{1.0f, 0.6f, 0.3f};           ///< linear, 0 to 1
    float glow_strength = 4;                          ///< radiance of glow_color 1
};

/// A panel, or the groove around it.
struct LathePanel {
    bool glows = false, is_second = false;
    float shade = 1;               ///< multiplies its albedo
    float gloss = 0.5f;            ///< as the gloss map, 0 to 1
    glm::vec2 lower{0}, upper{0};  ///< its place in the texture, 0 to 1
};

/// A quadrangle with a rectangle as its texture region. Corners: (u, v) lower lower, lower upper, upper upper, upper
/// lower.
struct LatheQuad {
    glm::vec3 position[4], normal[4];
    glm::vec2 lower, upper;
    uint32_t panel = 0;
    bool is_top = false;  ///< not one of the slanted edges
};

struct LatheParts {
    std::vector<LatheQuad> quads;
    std::vector<LathePanel> panels;
};

bool is_lathe_file(const std::filesystem::path& file);

/// Throws InputError: file: key: message.
Lathe read_lathe(const std::filesystem::path& file);

/// Every panel of it. The texture goes once around in u, and along the profile in v.
LatheParts turn_lathe(const Lathe& lathe);

/// Two triangles for each quadrangle, with one material.
Model lathe_model(const Lathe& lathe, const LatheParts& parts);

/// Gives every item made from a .lathe file its maps: albedo, coloured highlights, gloss, the exemption map (glowing
/// parts receive no light), and ambient occlusion. Occlusion is baked by rays against the item alone, since others
/// turn; kept in the cache, and written there whole or not at all. Must be prepared before chapter 04's maps are.
struct Finish : Module {
    Finish(Module& owner, std::string name);

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
    std::vector<std::string> load_exercises() const override { return {"16.bake_ray"}; }

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
