// Surface maps module: the maps in use, the method for bumps, and the mip levels of the maps.
#pragma once
#include <set>

#include "04_surface_maps/ggx_table.h"
#include "04_surface_maps/levels.h"
#include "common/app/module.h"
#include "common/image/image.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// How lamps that have a size are reflected by microfacets.
struct LampShapes : Module {
    using Module::Module;
    Choice method{*this,
                  "method",
                  {"point", "representative", "ltc", "sampled"},
                  "point",
                  "Reflection of lamps with a size by microfacets: as points, as the point nearest to the mirrored ray "
                  "(representative), by linearly transformed cosines (ltc), or by samples over the lamp"};
    Knob<int> samples{*this, "samples", 64, {1, 4096}, "Samples over each lamp, for the method 'sampled'"};

    Macros macros() const override {
        Macros all = Module::macros();
        if (!method.is("point"))
            all.replace_file("03_attenuation/lamp_points.glsl", "04_surface_maps/lamp_shapes.glsl");
        return all;
    }
};

/// How surfaces reflect lights that do not say it themselves.
struct SurfaceModel : Module {
    using Module::Module;
    Choice model{
        *this,
        "model",
        {"blinn_phong", "ggx"},
        "blinn_phong",
        "Reflection of lights by surfaces whose material states no roughness: blinn_phong, or microfacets (ggx)"};
    Choice body{*this,
                "body",
                {"lambert", "oren_nayar"},
                "lambert",
                "Diffuse reflection below microfacets: Lambert's, or that of rough matt surfaces, which conserves "
                "energy, too (oren_nayar)"};

    void prepare(Gpu& gpu, Scene&) override { table_.load(gpu); }
    std::vector<Resource> reads() const override { return {table_.albedos, table_.cosines}; }
    void bind(Pass& pass) const override {
        pass.set_if_present("ggx_albedos", table_.albedos, linear_clamp);
        pass.set_if_present("ggx_cosines", table_.cosines, linear_clamp);
    }

  private:
    GgxTable table_;
};

/// Gives shaders map_surface() of 04_surface_maps/surface_maps.glsl. prepare() when a scene was loaded; then draw() in
/// passes that state it in `.with`.
struct Maps : Module {
    Maps(Module& owner, std::string name);

    SurfaceModel surface;
    LampShapes lamps;

    // [method]
    Choice method{*this,
                  "method",
                  {"flat", "normal", "offset", "offset_limited", "steep", "occlusion", "relief", "exact"},
                  "occlusion",
                  "Bump method: flat (none), normal (normal map only), then parallax: offset, offset_limited, steep, "
                  "occlusion, relief, and exact ray casting"};
    // [/method]
    Knob<int> steps{*this, "steps", 32, {1, 4096}, "Number of depth layers searched by steep, occlusion and relief"};
    Knob<float> height_m{*this, "height_m", 0.05f, {0.0f, 1.0f}, "Depth of black in the height map below the mesh",
                         "m"};
    Knob<float> displacement_m{*this,
                               "displacement_m",
                               0.05f,
                               {0.0f, 1.0f},
                               "Height difference between black and white in the displacement map",
                               "m"};
    Choice mesh{*this,
                "mesh",
                {"loaded", "displaced"},
                "loaded",
                "Geometry: the mesh as loaded, or subdivided and moved by the height map (displaced)"};
    Knob<int> subdivide{
        *this, "subdivide", 16, {1, 1024}, "Number of pieces into which each edge of a displaced triangle is cut"};
    Knob<float> strength{*this, "strength", 1.0f, {0.0f, 4.0f}, "Scale factor for the slopes in normal maps"};
    Knob<float> detail_tiles{*this,
                             "detail_tiles",
                             8.0f,
                             {0.0f, 64.0f},
                             "Number of repeats of the detail normal map across a texture's width"};
    Choice normal_y{*this,
                    "normal_y",
                    {"up", "down"},
                    "up",
                    "Direction of the green channel in normal maps: up (OpenGL) or down (DirectX)"};
    Choice filter{*this,
                  "filter",
                  {"renormalised", "toksvig"},
                  "toksvig",
                  "Filtering of distant normal maps: unit length again (renormalised), or with highlights widened by "
                  "the spread of normals (toksvig)"};
    Choice coverage{*this,
                    "coverage",
                    {"kept", "averaged"},
                    "kept",
                    "Alpha in small mip levels of cutouts: scaled so that coverage stays (kept), or only averaged, so "
                    "that leaves vanish"};
    Knob<float> cutoff{*this, "cutoff", 0.5f, {0.0f, 1.0f}, "Alpha threshold below which a fragment is discarded"};
    Knob<float> wobble{*this, "wobble", 0.0f, {0.0f, 0.2f}, "Amplitude of the texture wobble, in texture widths"};
    Knob<float> scroll{
        *this, "scroll", 0.0f, {-2.0f, 2.0f}, "Speed of the texture scroll along v, in texture widths per second"};

    // One switch for each texture slot. A slot that is off, or that a material has no texture for, is compiled out.
    Knob<bool> diffuse{*this, "diffuse", true, "Colour textures of materials"};
    Knob<bool> specular{*this, "specular", true, "Specular colour textures, which tint highlights"};
    Knob<bool> emissive{*this, "emissive", true, "Emissive textures, which glow"};
    Knob<bool> opacity{*this, "opacity", true, "Opacity textures, which cut holes"};
    Knob<bool> normal{*this, "normal", true, "Normal maps of materials"};
    Knob<bool> height{*this, "height", true, "Height maps for parallax and displacement"};
    Knob<bool> orm{*this, "orm", true, "Textures with occlusion, roughness and metalness in one"};
    Knob<bool> occlusion{*this, "occlusion", true, "Ambient occlusion textures without roughness and metalness"};
    Knob<bool> gloss{*this, "gloss", true, "Gloss textures: specular exponents from 8 to 256"};
    Knob<bool> detail_normal{*this, "detail_normal", true, "Detail normal maps, blended onto the normal maps"};
    Knob<bool> displacement{*this, "displacement", true, "Displacement maps, which shift all textures along the view"};
    Knob<bool> metallic_roughness{*this, "metallic_roughness", true,
                                  "Textures with roughness and metalness, as glTF has"};
    Knob<bool> vertex_colors{*this, "vertex_colors", true, "Colours of vertices, which tint materials"};

    /// Tangents for the scene's meshes, and the levels of its maps unless `makes_levels` is off.
    void prepare(Gpu& gpu, Scene& scene) override;

    bool makes_levels = true;  ///< false: somebody else does

    void expand(std::vector<const PassInputs*>& into) const override {
        Module::expand(into);
        into.insert(into.end(), {&surface, &lamps});
    }

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

    /// Whether microfacets reflect light on it (GGX), rather than Blinn and Phong's model.
    bool has_microfacets(const DrawItem& item) const { return item.material.microfacets || surface.model.is("ggx"); }

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

/// Rebuilds levels that are not plain colour means: normal maps (see normal_levels) and alpha (see cutout_levels;
/// `cutoff` below 0: averaged; a material may have its own). Height maps keep only their first level, in 16 bits;
/// displacement maps have 16 bits and all levels. Returns the colour and opacity maps that are incomplete.
std::set<const Image*> make_mips(Gpu& gpu, Scene& scene, float cutoff);

/// The first level of an image as numbers; sRGB becomes linear. Waits for the device.
Level read_level(Gpu& gpu, const Image& image);

/// A normal map's levels as make_mips() has them; on any thread. For ImagePool::derived, as `normal_levels_name`.
std::vector<std::vector<std::byte>> normal_map_levels(const DecodedTexture& texture);
inline constexpr const char* normal_levels_name = "normal levels";

/// The mean of a picture of hit errors or of swimming over the pixels where there is one, in texels of the height map.
double mean_texels(const ImageRgb& picture);

}  // namespace lightwalk
