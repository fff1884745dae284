// Shadows of a scene's lights as a module: depth from each light that casts one, and how it is asked.
#pragma once
#include <map>

#include "03_attenuation/lights.h"
#include "05_shadow_maps/light_view.h"
#include "05_shadow_maps/moments.h"
#include "common/app/target.h"
#include "common/scene/scene.h"

namespace lightwalk {

// [shadow]
/// Gives shaders light_visibility() of 05_shadow_maps/shadow.glsl, by which 03_attenuation/lighting.glsl weighs every
/// light: include it where a chapter without shadows includes 03_attenuation/unshadowed.glsl. A light casts a shadow
/// where the scene says "shadow": true. After Lights::update(), record() for a view; then passes that draw this view may
/// state it in `.with`, beside the lights.
struct Shadow : Module {
    Shadow(Module& owner, std::string name);

    Choice method{
        *this,
        "method",
        {"none", "hard", "pcf", "pcss", "vsm", "evsm", "msm"},
        "pcf",
        "how maps of depth are asked: a texel, a square of them, one as wide as the shadow is soft, or moments"};
    Knob<int> resolution{*this, "resolution", 1024, {16, 8192}, "of a map's side", "texels"};
    Knob<int> cascades{*this, "cascades", 3, {1, 4}, "maps of a directional light, the finest next to the eye"};
    Knob<float> split{*this, "split", 0.7f, {0.0f, 1.0f}, "0: cascades are equally deep; 1: they grow by one factor"};
    Knob<float> distance_m{*this, "distance_m", 30.0f, {1.0f, 1e5f}, "how far from the eye cascades reach", "m"};
    Knob<bool> snap{*this, "snap", true, "cascades move by whole texels, so that edges of shadows stand still"};
    Knob<float> near_m{*this, "near_m", 0.05f, {1e-3f, 10.0f}, "where the map of a point or spot light begins", "m"};

    Knob<bool> keep{*this, "keep", true, "a map whose light and casters stand still is not drawn again"};

    // Bias: each alone, or together.
    Knob<float> bias_m{*this, "bias_m", 0.002f, {0.0f, 1.0f}, "points are lifted towards the light by this", "m"};
    Knob<float> slope{*this, "slope", 0.0f, {0.0f, 4.0f}, "and by this times what slope_bias() says"};
    Knob<float> normal_offset{*this, "normal_offset", 0.0f, {0.0f, 4.0f}, "the same along the surface's normal"};
    Knob<bool> receiver_plane{*this, "receiver_plane", true, "each texel is compared with the surface's plane in it"};

    // Filters of depths.
    Knob<int> kernel{*this, "kernel", 5, {1, 15}, "of pcf: the side of its square, odd", "texels"};
    Choice fetch{*this, "fetch", {"single", "gather"}, "gather", "of pcf: texels one by one, or four at a time"};
    Knob<int> search_taps{*this, "search_taps", 16, {1, 256}, "of pcss: where it looks for what is in the way"};
    Knob<int> taps{*this, "taps", 24, {1, 256}, "of pcss: from how many places it takes the mean"};

    // Filters of moments.
    Choice format{*this, "format", {"fp16", "fp32"}, "fp32", "of moments"};
    Knob<int> blur{*this, "blur", 3, {0, 16}, "of moments: texels to each side", "texels"};
    Choice blur_by{
        *this, "blur_by", {"naive", "shared"}, "shared", "who reads for the blur: each, or a workgroup once"};
    Knob<bool> mips{*this, "mips", true, "where a texel is narrower than a pixel, a smaller mip is read"};
    Knob<float> exponent{*this, "exponent", 40.0f, {0.0f, 80.0f}, "of evsm; as much as the format holds is used"};
    Knob<float> exponent_negative{*this, "exponent_negative", 5.0f, {0.0f, 80.0f}, "of evsm, against leaks behind"};
    Knob<float> min_variance{*this, "min_variance", 1e-7f, {1e-12f, 1.0f}, "of vsm and evsm: less is noise"};
    Knob<float> moment_bias{*this, "moment_bias", 1e-5f, {0.0f, 0.1f}, "of msm: moments are drawn to safe ones"};
    Knob<float> bleed{*this, "bleed", 0.0f, {0.0f, 0.9f}, "less light than this counts as none, the rest is stretched"};
    // [/shadow]

    /// How casters are drawn into a map, for chapters that cut holes into surfaces: a pass with these modules, which
    /// has the light's `view`. Otherwise all of them are solid.
    struct Casters {
        std::vector<With> with;
        std::function<void(Raster& pass, const DrawList& casters)> draw;
    };
    Pipeline solid =
        graphics({.vertex = "03_attenuation/surface.vert", .cull = VK_CULL_MODE_NONE, .depth_clamp = true});

    /// Depth from every light of `lights` that casts a shadow, where it is not in the map already.
    void record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters = {});

    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    void prepare(Gpu&, Scene&) override { forget(); }

    /// What is not seen from the scene's placement has changed: another scene, textures that cut other holes.
    void forget();

    const Image& moments() const { return now_->moments.moments; }

    int views = 0, drawn_views = 0;  ///< of the last frame: maps that exist, and those of them that were drawn

  private:
    /// What a layer of the map was drawn from.
    struct Drawn {
        glm::mat4 view{0.0f};
        std::vector<std::pair<uint32_t, glm::mat4>> casters;
        bool operator==(const Drawn&) const = default;
    };
    struct Wanted {
        LightView view;
        DrawList casters;
        Drawn key;
    };
    std::vector<Wanted> find_views(const Scene& scene, const Lights& lights, const Camera& camera);
    void draw_view(Frame& frame, const Wanted& wanted, const Casters& casters);
    void reserve(Frame& frame, uint32_t layers);

    bool has_moments() const { return method.is("vsm") || method.is("evsm") || method.is("msm"); }
    std::string moments_key() const;

    /// Cascades follow the eye. So that two views of one frame do not draw each other's maps again and again, each
    /// View::id has maps of its own where a light has cascades; else all views share those of id 0.
    struct ViewMaps {
        Image map;
        MomentMaps moments;
        std::string blurred;       ///< how
        std::vector<Drawn> drawn;  ///< by layer
        Buffer lights, views;
        ShadowEye eye{};
    };
    std::map<uint32_t, ViewMaps> by_view_;
    ViewMaps* now_ = &by_view_[0];  ///< of the view recorded last
    unsigned toggles_ = 0;
    std::vector<ShadowLight> shadow_lights_;
};

}  // namespace lightwalk
