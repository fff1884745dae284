// Lights module: a scene's lights in a buffer, with culling for each pixel.
#pragma once
#include "03_attenuation/light_grid.h"
#include "03_attenuation/object_lights.h"
#include "common/app/module.h"

namespace lightwalk {

// [lights]
/// GLSL: light_surface() of 03_attenuation/lighting.glsl. Per frame: update(); the scene's depth if needs_depth();
/// record() for a view; then passes of this view with the module in `.with`.
struct Lights : Module {
    Lights(Module& owner, std::string name) : Module(owner, std::move(name), "lights") {}

    Choice method{*this,
                  "method",
                  {"every_light", "per_object", "tiled", "clustered"},
                  "clustered",
                  "Light culling: all lights (every_light), or those that may reach the pixel's object (per_object), "
                  "screen tile (tiled) or cluster (clustered)"};
    Choice falloff{
        *this,
        "falloff",
        {"range_fade", "inverse_square_window", "inverse_square"},
        "inverse_square_window",
        "Distance attenuation: range_fade, inverse_square_window (0 at the range), or inverse_square (never 0)"};
    // [/lights]
    Knob<float> fade_k{
        *this, "fade_k", 1.0f, {0.0f, 100.0f}, "Constant k of range_fade, the quadratic term of its denominator",
        "1/m²"};
    Knob<float> threshold{*this,
                          "threshold",
                          0.004f,
                          {1e-6f, 1.0f},
                          "Radiance below which culling treats an inverse_square light as ended"};
    Knob<int> slices{*this, "slices", 24, {1, 256}, "Number of depth slices, and so of clusters, in each tile"};

    /// Uploads the lights and each object's list if they have changed.
    void update(Frame& frame, const Scene& scene, const LightList& lights);
    void update(Frame& frame, const Scene& scene, const std::vector<Light>& lights);

    /// Whether record() reads the view's depth.
    bool needs_depth() const { return method.is("tiled"); }

    /// Lays out the view's tiles or clusters, still without lights.
    void set_cells(Frame& frame, const Scene& scene, const View& view);
    bool has_cells() const { return method.is("tiled") || method.is("clustered"); }

    /// set_cells(), then the lights of each cell. `depth`: the view's, where needs_depth().
    void record(Frame& frame, const Scene& scene, const View& view, const ImageView& depth = {});

    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    const LightBuffer& buffer() const { return buffer_; }
    LightGrid grid;
    std::vector<std::string> status() const override;

    /// Culling radius of a point or spot light, in metres.
    float reach_m(const Light& light) const { return influence_radius(pack(light), ends_at()); }

  private:
    void update_objects(Frame& frame, const Scene& scene);
    float ends_at() const { return falloff.is("inverse_square") ? threshold : 0.0f; }
    LightBuffer buffer_;
    ObjectLights object_lights_;
};

}  // namespace lightwalk
