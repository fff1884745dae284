// Surfaces that textures describe, as a module: which maps are in use, how bumps are shown, and the maps' smaller
// levels.
#pragma once
#include <set>

#include "04_surface_maps/levels.h"
#include "common/app/module.h"
#include "common/image/image.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Gives shaders map_surface() of 04_surface_maps/surface_maps.glsl. prepare() when a scene was loaded; then draw() in
/// passes that state it in `.with`.
struct Maps : Module {
    Maps(Module& owner, std::string name);

    // [method]
    Choice method{*this,
                  "method",
                  {"flat", "normal", "offset", "offset_limited", "steep", "occlusion", "relief", "exact"},
                  "occlusion",
                  "how a surface's bumps are shown; from offset on, where the eye's ray meets the height map"};
    // [/method]
    Knob<int> steps{*this, "steps", 32, {1, 4096}, "how often steep, occlusion and relief look at the height map"};
    Knob<float> height_m{*this, "height_m", 0.05f, {0.0f, 1.0f}, "how deep black lies in a height map", "m"};
    Knob<float> displacement_m{
        *this, "displacement_m", 0.05f, {0.0f, 1.0f}, "how far black and white lie apart in a displacement map", "m"};
    Choice mesh{*this, "mesh", {"loaded", "displaced"}, "loaded", "displaced: the height map moves a finely cut mesh"};
    Knob<int> subdivide{*this, "subdivide", 16, {1, 1024}, "into how many a displaced triangle's edge is cut"};
    Knob<float> strength{*this, "strength", 1.0f, {0.0f, 4.0f}, "by what the slope in normal maps is multiplied"};
    Knob<float> detail_tiles{
        *this, "detail_tiles", 8.0f, {0.0f, 64.0f}, "how often detail repeats in a texture's width"};
    Choice normal_y{
        *this, "normal_y", {"up", "down"}, "up", "where green points in normal maps: up (OpenGL), down (DirectX)"};
    Choice filter{
        *this, "filter", {"renormalised", "toksvig"}, "toksvig", "what far away normal maps do to highlights"};
    Choice coverage{
        *this, "coverage", {"kept", "averaged"}, "kept", "how alpha is made smaller: averaged lets leaves vanish"};
    Knob<float> cutoff{*this, "cutoff", 0.5f, {0.0f, 1.0f}, "what has less alpha is cut out"};
    Knob<float> wobble{*this, "wobble", 0.0f, {0.0f, 0.2f}, "how far textures swing, in texture widths"};
    Knob<float> scroll{*this, "scroll", 0.0f, {-2.0f, 2.0f}, "how far textures flow, in texture widths a second"};

    // One switch for each texture slot. A slot that is off, or that a material has no texture for, is compiled out.
    Knob<bool> diffuse{*this, "diffuse", true, "colour textures"};
    Knob<bool> specular{*this, "specular", true, "textures that tint highlights"};
    Knob<bool> emissive{*this, "emissive", true, "textures that glow"};
    Knob<bool> opacity{*this, "opacity", true, "textures of holes"};
    Knob<bool> normal{*this, "normal", true, "normal maps"};
    Knob<bool> height{*this, "height", true, "height maps"};
    Knob<bool> orm{*this, "orm", true, "textures of occlusion, roughness and metalness"};
    Knob<bool> occlusion{*this, "occlusion", true, "textures of ambient occlusion alone"};
    Knob<bool> gloss{*this, "gloss", true, "textures of the exponent, 8 to 256"};
    Knob<bool> detail_normal{*this, "detail_normal", true, "fine normal maps on top of the others"};
    Knob<bool> displacement{*this, "displacement", true, "maps that shift all textures along the view"};

    /// Tangents for the scene's meshes, and the levels of its maps unless `makes_levels` is off.
    void prepare(Gpu& gpu, Scene& scene) override;

    bool makes_levels = true;  ///< false: somebody else does

    /// Draws the scene with 04_surface_maps' vertex shaders before `fragment`'s: `loaded` and `displaced` are pipelines
    /// with surface.vert and displaced.vert. Each item by the variant that has just its maps.
    void draw(Raster& pass, const Scene& scene, const Pipeline& loaded, const Pipeline& displaced) const {
        draw(pass, scene, scene.all(), loaded, displaced);
    }
    void draw(Raster& pass, const Scene& scene, const DrawList& items, const Pipeline& loaded,
              const Pipeline& displaced) const {
        draw(pass, scene, items.batches(), loaded, displaced);
    }
    void draw(Raster& pass, const Scene& scene, const std::vector<Batch>& batches, const Pipeline& loaded,
              const Pipeline& displaced) const;

    /// Whether textures cut holes into it. Known after prepare().
    bool has_holes(const DrawItem& item) const;

    /// The macros of an item's own maps.
    Macros variant(const DrawItem& item) const;

    bool animated() const override { return wobble > 0 || scroll != 0; }
    std::string load_key() const override { return coverage.is("kept") ? cutoff.text() : coverage.text(); }
    std::vector<std::string> load_exercises() const override { return {"04.tangent_frame", "04.alpha_scale"}; }

  private:
    /// With each triangle cut into subdivide × subdivide.
    void draw_displaced(Raster& pass, const Batch& batch) const;

    std::set<const Image*> with_holes_;
};

/// Makes the levels anew of what must not be averaged as colours are: normal maps (see normal_levels) and alpha (see
/// cutout_levels; `cutoff` below 0: averaged). Of height maps only the first level is read, with 16 bits; displacement
/// maps have 16 bits, too, and all levels. Returns the colour and opacity maps that are not whole.
std::set<const Image*> make_mips(Gpu& gpu, Scene& scene, float cutoff);

/// The first level of an image as numbers; sRGB becomes linear. Waits for the device.
Level read_level(Gpu& gpu, const Image& image);

/// The mean of a picture of hit errors or of swimming over the pixels where there is one, in texels of the height map.
double mean_texels(const ImageRgb& picture);

}  // namespace lightwalk
