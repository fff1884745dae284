// Shadow module: a depth map from each light that casts shadows, and the filters that read it.
#pragma once
#include <array>
#include <map>
#include <span>

#include "03_attenuation/lights.h"
#include "05_shadow_maps/light_view.h"
#include "05_shadow_maps/moments.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [shadow]
/// Gives shaders light_visibility() of 05_shadow_maps/shadow.glsl, by which 03_attenuation/lighting.glsl weighs every
/// light: include it where a chapter without shadows includes 03_attenuation/unshadowed.glsl. A light casts a shadow
/// where the scene says "shadow": true. After Lights::update(), record() for a view; then passes that draw this view may
/// state it in `.with`, beside the lights.
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
    Knob<float> distance_m{
        *this, "distance_m", 30.0f, {1.0f, 1e5f}, "Distance from the camera at which the last cascade ends, in metres",
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

    // Bias: each alone, or together.
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
    // [/shadow]

    /// How casters are drawn into a map, for chapters that cut holes into surfaces: a pass with these modules, which
    /// has the light's `view`. Otherwise all of them are solid.
    struct Casters {
        using Draw = std::function<void(Raster& pass, const DrawList& casters)>;
        std::vector<With> with;
        Draw draw;
        /// Of transparent casters by 05_shadow_maps/passed.frag: the first that the light meets, or the product of all.
        Draw draw_first, draw_passed;
        /// Casters outside of the scene's items: within `others` (world space), drawn into each view after the items.
        /// A map is drawn again when `others_placed` changes.
        std::function<void(Raster& pass, const View& light)> draw_others;
        Bounds others;
        uint64_t others_placed;
    };
    Pipeline solid = graphics({.vertex = "05_shadow_maps/caster.vert", .cull = VK_CULL_MODE_NONE, .depth_clamp = true});

    /// Depth from every light of `lights` that casts a shadow, where it is not in the map already.
    void record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters = {});
    /// The same for directional lights that no module Lights has.
    void record(Frame& frame, const Scene& scene, const std::vector<Light>& directional, const View& view,
                const Casters& casters = {});

    /// With the file that holds the method's filter.
    Macros macros() const override;
    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    void prepare(Gpu&, Scene&) override;
    std::vector<std::string> status() const override;

    const Image& moments() const { return moments_.moments; }

    int views = 0, drawn_views = 0;  ///< maps of the view recorded last: all, and those drawn in its frame

  private:
    /// A map's view of the scene, and what it shows.
    struct MapView {
        LightView view;
        DrawList casters, passed;  ///< opaque, and transparent ones where these have shadows
        uint64_t shows = 0;        ///< hash of the light's view and of its casters
        bool others = false;
        bool is_needed() const { return others || casters.size() + passed.size() > 0; }
    };
    using Reach = std::function<float(const Light&)>;  ///< metres
    void find_views(const Scene& scene, const std::vector<Light>& lights, const Reach& reach, const View& view,
                    const Casters& casters);
    uint64_t hash_of(const MapView& map, const Scene& scene, const Casters& casters) const;
    void take_layers(Frame& frame, const View& view);
    void record(Frame& frame, const Scene& scene, const LightList& lights, const Reach& reach, const View& view,
                const Casters& casters);
    LightViewOptions view_options() const { return {resolution, near_m, cascades, split, distance_m, snap}; }
    void draw_map(Frame& frame, const MapView& map, const Casters& casters);
    void draw_passed(Frame& frame, const MapView& map, const Casters& casters);
    void reserve(Frame& frame);

    bool has_passed() const { return transparent.is("colored") && !method.is("none"); }
    bool has_moments() const { return method.is("vsm") || method.is("evsm") || method.is("msm"); }

    /// Cascades follow the camera: each View::id has maps of its own if a light has cascades; else all share those of
    /// id 0.
    struct OfView {
        Buffer lights, views;  ///< ShadowLight, ShadowView
        ShadowEye eye{};
        Fingerprint found_made, uploaded;
        LightList found_for;
        std::vector<MapView> maps;
        std::vector<ShadowLight> shadow_lights;
    };
    std::map<uint32_t, OfView> by_view_;
    LightList directional_;       ///< the last ones given without a module Lights
    OfView* now_ = &by_view_[0];  ///< of the view recorded last

    /// Where a map lies in the images, by its view (0 where the camera does not matter), light and number of the light's
    /// views. A map is drawn again if what it shows differs from what its layer holds.
    std::map<std::array<uint32_t, 3>, uint32_t> layer_of_;
    std::vector<uint64_t> held_;  ///< MapView::shows of each layer; 0: nothing
    Image map_;
    /// Transmittance of the first transparent caster, and of all; depths of the first and the last.
    Image first_, first_depth_, passed_, last_depth_;
    MomentMaps moments_;
};

}  // namespace lightwalk
