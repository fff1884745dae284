// Surroundings world: objects and a sphere in the light of a picture around them.
#pragma once
#include "14_environment/backdrop.h"
#include "14_environment/beat_data.h"
#include "14_environment/image_light.h"
#include "14_environment/lit_around.h"
#include "14_environment/music.h"
#include "14_environment/probe.h"
#include "common/app/drawing.h"
#include "common/app/world.h"

namespace lightwalk {

struct BeatLook : Module {
    using Module::Module;
    Knob<glm::vec3> valley{*this,
                           "valley",
                           {0.10f, 0.11f, 0.14f},
                           {glm::vec3(0), glm::vec3(1)},
                           "Reflectance of the metal in the valleys at normal incidence, linear"};
    Knob<glm::vec3> peak{*this,
                         "peak",
                         {1.0f, 0.78f, 0.5f},
                         {glm::vec3(0), glm::vec3(1)},
                         "Reflectance of the metal on the peaks at normal incidence, linear"};
    Knob<glm::vec3> glow{*this,
                         "glow",
                         {1.0f, 0.16f, 0.03f},
                         {glm::vec3(0), glm::vec3(1)},
                         "Colour of the light that valleys emit, linear"};
    Knob<float> roughness{*this, "roughness", 0.22f, {0.0f, 1.0f}, "Roughness of the metal"};
};

/// A sphere with vertices displaced along its normal in the vertex shader: by the logarithm of the surroundings'
/// brightness, and by waves of three spatial frequencies with heights set by the levels of the music.
struct BeatSphere : Drawing {
    BeatSphere(Module& owner, std::string name, const ImageLight& light, Music& music);

    Knob<bool> shown{*this, "shown", false, "Presence of the sphere in the scene"};
    Choice normal{*this,
                  "normal",
                  {"sphere", "differences", "analytic"},
                  "analytic",
                  "Normal of the displaced surface: the undisplaced sphere's, from four displaced neighbours, or from "
                  "the derivatives of the waves"};
    Knob<glm::vec3> center{
        *this, "center", {0.0f, 1.5f, 0.0f}, {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Position of the centre, world space",
        "m"};
    Knob<float> radius_m{*this, "radius_m", 1.0f, {1e-3f, 1e4f}, "Radius of the sphere at rest", "m"};
    Knob<float> low{*this, "low", 0.4f, {0.0f, 2.0f}, "Height of the waves of the low band, as a share of the radius"};
    Knob<float> middle{*this, "middle", 0.4f, {0.0f, 2.0f}, "Height of the waves of the middle band"};
    Knob<float> high{*this, "high", 0.06f, {0.0f, 2.0f}, "Height of the waves of the high band"};
    Knob<float> brightness{*this,
                           "brightness",
                           0.015f,
                           {0.0f, 0.15f},
                           "Height of each doubling of the surroundings' radiance over its mean"};
    Knob<float> blur{*this,   "blur", 4.0f, {0.0f, 8.0f}, "Level of the surroundings' cube whose brightness counts",
                     "levels"};
    Knob<glm::vec3> frequencies{*this,
                                "frequencies",
                                {7.0f, 14.0f, 56.0f},
                                {glm::vec3(0), glm::vec3(100)},
                                "Spatial frequency of the waves of the three bands, in radians along a radius"};
    Knob<float> spin_deg_per_s{*this,  "spin_deg_per_s", 12.0f, {-3600.0f, 3600.0f}, "Rotation of the waves about +y",
                               "deg/s"};
    Knob<float> tilt_deg{*this, "tilt_deg", 20.0f, {-360.0f, 360.0f}, "Tilt of the axis of that rotation towards +z",
                         "deg"};
    Knob<float> glow{*this, "glow", 3.0f, {0.0f, 1e3f}, "Radiance of the valleys at full loudness"};
    Knob<bool> ground{*this, "ground", true, "Shade and glow of the sphere on level ground"};
    Knob<float> ground_y{*this, "ground_y", 0.0f, {-1e4f, 1e4f}, "Height of that ground", "m"};
    BeatLook look{*this, "look", "beat_look"};

    void prepare(Gpu& gpu, Scene& scene) override;
    void update(Frame& frame) override;
    std::vector<const Module*> dependencies() const override { return {this, &light_, &music_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    bool animated() const override;
    void bind(Pass& pass) const override;

    const BeatNow& now() const { return now_; }

  private:
    void shade_ground(Frame& frame, const View& view, Canvas& canvas);
    const ImageLight& light_;
    Music& music_;
    Pipeline surface_ =
        graphics({.vertex = "14_environment/beat_sphere.vert", .fragment = "14_environment/beat_sphere.frag"});
    Pipeline ground_ = compute({.shader = "14_environment/beat_ground.comp"});
    Buffer directions_, indices_;
    BeatNow now_{};
};

/// Directions of unit length, and triangles counter-clockwise seen from outside.
struct Geodesic {
    std::vector<glm::vec3> directions;
    std::vector<uint32_t> indices;
};

/// An icosahedron with each edge divided into `parts` (1 to 1000): 20 parts^2 triangles, each vertex once.
Geodesic geodesic_sphere(uint32_t parts);

struct Surroundings : World {
    /// `heard`: the sphere's music; null: the scene's own.
    explicit Surroundings(Module& owner, Music* heard = nullptr);

    ImageLight light{*this, "environment"};
    Backdrop backdrop{*this, "backdrop", light};
    LitAround objects{*this, "objects", light};
    Music music{*this, "music"};
    BeatSphere sphere;
    SceneProbe probe{*this, "probe"};

    Drawings drawings() override { return {backdrop, objects, sphere}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }

  protected:
    void record(Frame& frame) override;
};

}  // namespace lightwalk
