// Shadow module: a depth map from each light that casts shadows, and the filters that read it.
#pragma once
#include <array>
#include <map>
#include <span>

#include "03_attenuation/lights.h"
#include "05_shadow_maps/blur.h"
#include "05_shadow_maps/light_view.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Gaussian blur with `radius` texels to each side (0 to 16), cut off at 2.5 standard deviations.
Blur blur_of(int radius, float exponent, float exponent_negative);

/// Blurred moments of a depth map's layers, with mips.
class MomentMaps {
  public:
    /// Images for all layers of `map`; true if they were recreated.
    bool ensure(Gpu& gpu, const Image& map, VkFormat format);

    /// Moments of one layer, seen by entry `view` of `views`. `macros`: the module Shadow's, which select moments,
    /// format and blur.
    void record(Frame& frame, const ImageView& layer, const Buffer& views, uint32_t view, Blur blur,
                const Macros& macros);

    Image moments;

  private:
    Image between_;  ///< after the blur along u
    Pipeline first_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "0"}}});
    Pipeline second_ = compute({.shader = "05_shadow_maps/blur.comp", .macros = {{"PASS", "1"}}});
    Pipeline halve_ = compute({.shader = "05_shadow_maps/halve_moments.comp"});
};

/// GLSL: light_visibility() of 05_shadow_maps/shadow.glsl, included instead of 03_attenuation/unshadowed.glsl. Lights
/// with "shadow": true in the scene cast shadows. Per view, after Lights::update(): record(); then passes of this view
/// with the module in `.with`, beside the lights.
struct Shadow : Module {
    Shadow(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "hard", "pcf", "pcss", "vsm", "evsm", "msm"},
                  "pcf",
                  "Shadow filter: none, one comparison (hard), a fixed kernel (pcf), a kernel as wide as the penumbra "
                  "(pcss), or blurred moments (vsm, evsm, msm)"};
    Knob<int> resolution{
        *this,   "resolution", 1024, {16, 8192}, "Shadow map resolution: width and height of each map, in texels",
        "texels"};
    Knob<int> cascades{*this, "cascades", 3, {1, 4}, "Number of shadow cascades for each directional light"};
    Knob<float> split{
        *this,
        "split",
        0.7f,
        {0.0f, 1.0f},
        "Cascade distribution: 0 makes all equally deep, 1 makes each deeper than the last by a constant factor"};
    Knob<float> distance_m{*this,
                           "distance_m",
                           30.0f,
                           {1.0f, 1e5f},
                           "Distance from the camera at which the last cascade ends, in metres; by default at least "
                           "1.25 times the distance to the camera's target",
                           "m"};
    Knob<bool> snap{*this, "snap", true,
                    "Cascade snapping to whole texels, which keeps shadow edges still as the camera moves"};
    Knob<float> near_m{*this, "near_m", 0.05f, {1e-3f, 10.0f}, "Near plane of point and spot light maps, in metres",
                       "m"};

    Choice transparent{*this,
                       "transparent",
                       {"none", "colored"},
                       "none",
                       "Shadow of transparent surfaces: none, or coloured by the light that they let through"};
    Knob<bool> keep{*this, "keep", true, "Caching: a map is redrawn only if its light or a caster in it has moved"};

    // Biases, which can be combined.
    Knob<float> bias_m{*this, "bias_m", 0.002f, {0.0f, 1.0f}, "Constant bias towards the light, in metres", "m"};
    Knob<float> slope{*this, "slope", 0.0f, {0.0f, 4.0f}, "Scale factor for the slope bias, towards the light"};
    Knob<float> normal_offset{
        *this, "normal_offset", 0.0f, {0.0f, 4.0f}, "Scale factor for the bias along the surface normal"};
    Knob<bool> receiver_plane{
        *this, "receiver_plane", true,
        "Receiver-plane bias: each texel is compared with the depth of the surface's plane at that texel"};

    // Filters of depths.
    Knob<int> kernel{*this, "kernel", 5, {1, 15}, "PCF kernel width, in texels; odd", "texels"};
    Choice fetch{*this,
                 "fetch",
                 {"single", "gather"},
                 "gather",
                 "PCF texture reads: one texel each (single), or four at a time (gather)"};
    Knob<int> search_taps{*this, "search_taps", 16, {1, 256}, "Number of samples in the PCSS blocker search"};
    Knob<int> taps{*this, "taps", 24, {1, 256}, "Number of samples in the PCSS filter"};

    // Filters of moments.
    Choice format{*this,
                  "format",
                  {"fp16", "fp32"},
                  "fp32",
                  "Precision of moment maps: 16-bit floats (fp16) or 32-bit floats (fp32)"};
    Knob<int> blur{*this, "blur", 3, {0, 16}, "Blur radius of moment maps, in texels", "texels"};
    Choice blur_by{*this,
                   "blur_by",
                   {"naive", "shared"},
                   "shared",
                   "Blur implementation: every invocation reads all its taps (naive), or a workgroup reads each texel "
                   "once into shared memory (shared)"};
    Knob<bool> mips{*this, "mips", true, "Mip maps of moment maps, read where a texel is narrower than a pixel"};
    Knob<float> exponent{
        *this, "exponent", 40.0f, {0.0f, 80.0f}, "EVSM positive exponent, limited to what the format can hold"};
    Knob<float> exponent_negative{*this,
                                  "exponent_negative",
                                  5.0f,
                                  {0.0f, 80.0f},
                                  "EVSM negative exponent, against leaks behind the second blocker"};
    Knob<float> min_variance{*this,
                             "min_variance",
                             1e-7f,
                             {1e-12f, 1.0f},
                             "Minimum variance for VSM and EVSM, below which it counts as noise"};
    Knob<float> moment_bias{*this,
                            "moment_bias",
                            1e-5f,
                            {0.0f, 0.1f},
                            "MSM moment bias: weight of a neutral set of moments mixed in for stability"};
    Knob<float> bleed{
        *this,
        "bleed",
        0.0f,
        {0.0f, 0.9f},
        "Light-bleeding reduction: visibility up to this value becomes 0, the rest is rescaled to 0 to 1"};

    /// Draws of casters into a map, in a pass with these modules and the light's `view`. Default: all are solid.
    struct Casters {
        using Draw = std::function<void(Raster& pass, const DrawList& casters)>;
        std::vector<With> with;
        Draw draw;
        /// Transparent casters, by 05_shadow_maps/passed.frag: the one nearest to the light, or the product of all.
        Draw draw_first, draw_passed;
        /// Casters other than scene items, within the world-space box `others`, drawn after the items. A change of
        /// `others_placed` redraws the maps.
        std::function<void(Raster& pass, const View& light)> draw_others;
        Bounds others;
        uint64_t others_placed;
    };
    Pipeline solid = graphics({.vertex = "05_shadow_maps/caster.vert", .cull = VK_CULL_MODE_NONE, .depth_clamp = true});

    /// View of a shadow map, with its casters.
    struct MapView {
        LightView view;
        DrawList casters, passed;  ///< opaque casters, and transparent ones that cast shadows
        uint64_t shows = 0;        ///< hash of the light's view and of its casters
        bool others = false;
        bool is_needed() const { return others || casters.size() + passed.size() > 0; }
    };
    using MapViews = std::vector<std::reference_wrapper<const MapView>>;

    /// Finds the views of all lights that cast shadows, their casters, and a layer for each; uploads lights and views.
    void find_maps(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters);
    /// Maps whose layers are out of date; they count as drawn.
    MapViews maps_to_draw();
    ImageView depth_of(const MapView& map) const { return map_.layer(map.view.data.layer); }
    void draw_map(Frame& frame, const MapView& map, const Casters& casters);
    /// Transmittance of transparent casters.
    void draw_passed(Frame& frame, const MapView& map, const Casters& casters);
    /// Moments of a map's depths, blurred, and their mip levels.
    void filter(Frame& frame, const MapView& map);
    bool has_passed() const { return transparent.is("colored") && !method.is("none"); }
    bool has_moments() const { return method.is("vsm") || method.is("evsm") || method.is("msm"); }

    /// find_maps(), then every map to draw.
    void record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters = {});
    /// record() for directional lights without a module Lights.
    void record(Frame& frame, const Scene& scene, const std::vector<Light>& directional, const View& view,
                const Casters& casters = {});

    /// Replaces the filter file with the method's.
    Macros macros() const override;
    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    void prepare(Gpu&, Scene&) override;
    std::vector<std::string> status() const override;

    const Image& moments() const { return moments_.moments; }

    int views = 0, drawn_views = 0;  ///< maps of the last view: all, and those drawn

  private:
    using Reach = std::function<float(const Light&)>;  ///< range of a light, metres
    void find_views(const Scene& scene, const std::vector<Light>& lights, const Reach& reach, const View& view,
                    const Casters& casters);
    uint64_t hash_of(const MapView& map, const Scene& scene, const Casters& casters) const;
    void take_layers(Frame& frame, const View& view);
    void find_maps(Frame& frame, const Scene& scene, const LightList& lights, const Reach& reach, const View& view,
                   const Casters& casters);
    void draw_maps(Frame& frame, const Casters& casters);
    LightViewOptions view_options(const Camera& camera) const;
    void reserve(Frame& frame);

    /// Maps by View::id if a light has cascades, which follow the camera; else all views share those of id 0.
    struct OfView {
        Buffer lights, views;  ///< ShadowLight, ShadowView
        ShadowEye eye{};
        Fingerprint found_made, uploaded;
        LightList found_for;
        std::vector<MapView> maps;
        std::vector<ShadowLight> shadow_lights;
    };
    std::map<uint32_t, OfView> by_view_;
    LightList directional_;       ///< last argument of record() without a module Lights
    OfView* now_ = &by_view_[0];  ///< state of the last view

    /// Layer of a map by View::id (0 if independent of the camera), light, and index of the light's view.
    std::map<std::array<uint32_t, 3>, uint32_t> layer_of_;
    std::vector<uint64_t> held_;  ///< MapView::shows of each layer's content; 0: empty
    Image map_;
    /// Transmittance of the first transparent caster and of all; depths of the first and last.
    Image first_, first_depth_, passed_, last_depth_;
    MomentMaps moments_;
};

}  // namespace lightwalk
