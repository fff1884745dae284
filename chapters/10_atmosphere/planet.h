// Planet: the ground as a sphere with its maps, and the stars behind it.
#pragma once
#include "10_atmosphere/atmosphere.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

/// Draws the background of the air: where no depth was drawn, the planet's ground, or the stars. A sea reflects.
struct Planet : Drawing {
    Planet(Module& owner, std::string name, Atmosphere& atmosphere);

    Choice map{*this,
               "map",
               {"plain", "earth", "mars"},
               "earth",
               "Surface of the planet: one colour, or a map of the Earth or of Mars"};
    Knob<float> latitude_deg{*this,    "latitude_deg", 0.0f, {-90.0f, 90.0f}, "Latitude of the world origin on the map",
                             "degrees"};
    Knob<float> longitude_deg{
        *this, "longitude_deg", 0.0f, {-180.0f, 180.0f}, "Longitude of the world origin on the map", "degrees"};
    Knob<float> turn_deg{*this,    "turn_deg", 0.0f, {-360.0f, 360.0f}, "Rotation of the map about the world origin",
                         "degrees"};
    Knob<glm::vec3> color{*this,
                          "color",
                          {0.05f, 0.09f, 0.12f},
                          {glm::vec3(0.0f), glm::vec3(1.0f)},
                          "Albedo of plain ground; a factor for the colours of a map"};
    Knob<float> sea{*this, "sea", 1.0f, {0.0f, 1.0f}, "Fraction of water on plain ground; on a map, of its water"};
    Knob<float> waves{*this, "waves", 0.12f, {0.005f, 1.0f}, "Standard deviation of the slopes of waves"};
    Knob<float> clouds{*this, "clouds", 1.0f, {0.0f, 1.0f}, "Opacity of the clouds of the map"};
    Knob<float> night{*this, "night", 0.02f, {0.0f, 1e3f}, "Luminance of cities by night, in kcd/m²"};
    Knob<float> stars{*this, "stars", 0.02f, {0.0f, 1e6f}, "Luminance of the stars, in kcd/m²"};

    Knob<float> snow_m{*this, "snow_m", 1300.0f, {-1e5f, 1e5f}, "Snow line: height above which mountains are white",
                       "m"};

    void prepare(Gpu& gpu, Scene&) override;
    std::string load_key() const override { return map.text(); }
    Phase draw_phase() const override { return Phase::sky; }
    const Drawing* sun_source() const override { return &atmosphere_; }
    std::vector<const Module*> dependencies() const override { return {this, &atmosphere_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    void bind(Pass& pass) const override;

  private:
    const Atmosphere& atmosphere_;
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> day_, night_, clouds_, water_, stars_;
    Pipeline ground_ = compute({.shader = "10_atmosphere/ground.comp"});
};

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

  private:
    const Atmosphere& atmosphere_;
    const Planet& planet_;
    Image noise_;
    bool has_noise_ = false;
    Pipeline make_noise_ = compute({.shader = "10_atmosphere/cloud_noise.comp"});
    Pipeline march_ = compute({.shader = "10_atmosphere/cloud_layer.comp"});
};

}  // namespace lightwalk
