// Cloud layer module: clouds with a height and a depth, between two heights of a planet's air.
#pragma once
#include "10_atmosphere/planet.h"

namespace lightwalk {

// [cloud_layer]
/// Drawn after the air: it takes the air before the clouds from the tables of Atmosphere's method `tables`. Far from the
/// origin the planet's map says where clouds are.
struct CloudLayer : Drawing {
    CloudLayer(Module& owner, std::string name, const Atmosphere& atmosphere, const Planet& planet)
        : Drawing(owner, std::move(name), "clouds"), atmosphere_(atmosphere), planet_(planet) {}

    Choice method{*this, "method", {"none", "march"}, "none", "Clouds: none, or a march through the layer"};
    Knob<float> base_m{*this, "base_m", 2600.0f, {0.0f, 2e4f}, "Height of the layer's lower side", "m"};
    Knob<float> top_m{*this, "top_m", 5200.0f, {1.0f, 3e4f}, "Height of the layer's upper side", "m"};
    Knob<float> cover{*this, "cover", 0.6f, {0.0f, 1.0f}, "Share of the sky that clouds cover around the origin"};
    Knob<float> around_km{*this, "around_km", 150.0f, {0.1f, 1e4f}, "Radius around the origin in which `cover` holds",
                          "km"};
    Knob<float> extinction{*this, "extinction", 0.03f, {0.0f, 1.0f}, "Extinction coefficient of dense cloud", "1/m"};
    Knob<float> drift_m_s{*this, "drift_m_s", 0.0f, {-1e4f, 1e4f}, "Speed of the clouds towards +x", "m/s"};
    Knob<int> steps{*this, "steps", 80, {1, 1024}, "Number of samples on the path of a pixel through the layer"};

    Phase draw_phase() const override { return Phase::air; }
    const Drawing* sun_source() const override { return &atmosphere_; }
    std::vector<const Module*> dependencies() const override { return {this, &atmosphere_, &planet_}; }
    bool animated() const override { return !method.is("none") && drift_m_s != 0.0f; }
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    // [/cloud_layer]

  private:
    const Atmosphere& atmosphere_;
    const Planet& planet_;
    Image noise_;
    bool has_noise_ = false;
    Pipeline make_noise_ = compute({.shader = "10_atmosphere/cloud_noise.comp"});
    Pipeline march_ = compute({.shader = "10_atmosphere/cloud_layer.comp"});
};

}  // namespace lightwalk
