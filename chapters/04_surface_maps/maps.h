// Surface maps module: the maps in use, the method for bumps, and the mip levels of the maps.
#pragma once
#include <set>

#include "04_surface_maps/ggx_table.h"
#include "04_surface_maps/levels.h"
#include "common/app/module.h"
#include "common/image/image.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Pipelines of one fragment shader with this chapter's two vertex shaders.
struct SurfacePipelines {
    /// `desc`: fragment shader and common state.
    explicit SurfacePipelines(const Pipeline::Graphics& desc);
    Pipeline loaded, displaced;  ///< by Maps::mesh
};

/// Reflection of finite lamps by microfacets.
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

/// Reflection model of surfaces whose materials do not name one.
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

/// GLSL: map_surface() of 04_surface_maps/surface_maps.glsl. draw() in passes with the module in `.with`.
struct Maps : Module {
    Maps(Module& owner, std::string name);

    SurfaceModel surface;
    LampShapes lamps;

    Choice method{*this,
                  "method",
                  {"flat", "normal", "offset", "offset_limited", "steep", "occlusion", "relief", "exact"},
                  "occlusion",
                  "Bump method: flat (none), normal (normal map only), then parallax: offset, offset_limited, steep, "
                  "occlusion, relief, and exact ray casting"};
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
    Choice anisotropy{*this,
                      "anisotropy",
                      {"1", "2", "4", "8", "16"},
                      "1",
                      "Maximum number of reads of a map along a pixel's footprint, which is longer than wide where a "
                      "surface is seen at a grazing angle; 1: trilinear filtering"};
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

    // Switches of texture slots; those off or without a texture are compiled out.
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

    /// Tangents of the scene's meshes, and mip levels of its maps if `makes_levels`.
    void prepare(Gpu& gpu, Scene& scene) override;

    bool makes_levels = true;  ///< false: mip levels come from elsewhere

    void expand(std::vector<const PassInputs*>& into) const override {
        Module::expand(into);
        into.insert(into.end(), {&surface, &lamps});
    }

    /// Draws items, each by the shader variant with exactly its maps. `loaded` and `displaced`: pipelines with
    /// surface.vert and displaced.vert.
    void draw(Raster& pass, const Scene& scene, const Pipeline& loaded, const Pipeline& displaced) const {
        draw(pass, scene, scene.all(), loaded, displaced);
    }
    void draw(Raster& pass, const Scene& scene, const DrawList& items, const Pipeline& loaded,
              const Pipeline& displaced) const {
        draw(pass, scene, items.batches(), loaded, displaced);
    }
    void draw(Raster& pass, const Scene& scene, const std::vector<Batch>& batches, const Pipeline& loaded,
              const Pipeline& displaced) const;

    /// Whether textures cut holes into the item; valid after prepare().
    bool has_holes(const DrawItem& item) const;

    /// Whether the item uses GGX instead of Blinn–Phong.
    bool has_microfacets(const DrawItem& item) const { return item.material.microfacets || surface.model.is("ggx"); }

    /// Macros of the item's maps.
    Macros variant(const DrawItem& item) const;

    bool animated() const override { return wobble > 0 || scroll != 0; }
    std::string load_key() const override { return coverage.is("kept") ? cutoff.text() : coverage.text(); }
    std::vector<std::string> load_exercises() const override { return {"04.tangent_frame", "04.alpha_scale"}; }

  private:
    /// Draws with each triangle split into subdivide × subdivide.
    void draw_displaced(Raster& pass, const Batch& batch) const;

    std::set<const Image*> with_holes_;
};

/// Rebuilds mip levels of normal maps (normal_levels) and of alpha (cutout_levels; `cutoff` below 0: averaged;
/// materials may override it). Height maps keep only level 0, in 16 bits; displacement maps have 16 bits and all
/// levels. Returns the incomplete colour and opacity maps.
std::set<const Image*> make_mips(Gpu& gpu, Scene& scene, float cutoff);

/// Level 0 of an image as floats; sRGB becomes linear. Waits for the device.
Level read_level(Gpu& gpu, const Image& image);

/// Mip levels of a normal map; thread-safe. For ImagePool::derived, as `normal_levels_name`.
std::vector<std::vector<std::byte>> normal_map_levels(const DecodedTexture& texture);
inline constexpr const char* normal_levels_name = "normal levels";

/// Mean hit error or swimming over the pixels that have one, in texels of the height map.
double mean_texels(const ImageRgb& picture);

}  // namespace lightwalk
