// Solar system world: planets before the stars, seen from the scene's camera or on a flight.
#pragma once
#include <glm/gtc/quaternion.hpp>

#include "17_planets/planets.h"
#include "common/app/world.h"

namespace lightwalk {

/// Draws before all others: it overwrites the whole canvas. 8,777 stars of a catalogue as points, each of the same light
/// however many pixels the picture has, over the Milky Way of a map.
struct Stars : Drawing {
    Stars(Module& owner, std::string name, const Planets& planets);

    Knob<float> brightness{
        *this, "brightness", 6.0f, {0.0f, 1e4f}, "Radiance in the middle of a star of magnitude 0; 0: no stars"};
    Knob<float> sigma{*this,
                      "sigma",
                      0.0013f,
                      {1e-5f, 0.1f},
                      "Standard deviation of a star's image, as a fraction of the picture's height"};
    Knob<float> milky_way{*this, "milky_way", 0.5f, {0.0f, 1e3f}, "Scale factor for the map of the Milky Way"};

    void prepare(Gpu& gpu, Scene&) override;
    Phase draw_phase() const override { return Phase::backdrop; }
    std::vector<const Module*> dependencies() const override { return {this, &planets_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    const Planets& planets_;
    std::unique_ptr<ImagePool> pool_;
    std::shared_ptr<Image> map_;
    Buffer stars_;
    uint32_t count_ = 0;
    Pipeline sky_ = compute({.shader = "17_planets/milky_way.comp"});
    Pipeline points_ = graphics({.vertex = "17_planets/star.vert",
                                 .fragment = "17_planets/star.frag",
                                 .cull = VK_CULL_MODE_NONE,
                                 .depth_test = false,
                                 .depth_write = false,
                                 .blend = Blend::add});
};

/// A star as shaders read it: a unit vector of the world, and its light over that of a star of magnitude 0.
struct Star {
    glm::vec3 direction;
    float light;
};

/// Lines of `v_mag,ra_deg,dec_deg` after a line of names. Throws InputError: file:line: message.
std::vector<Star> read_stars(const std::filesystem::path& file);

/// From the Sun to Pluto, each body as its portrait has it, `stay_s` long, with flights of `travel_s` between; then from the
/// beginning again.
struct Flight : Module {
    Flight(Module& owner, std::string name, Planets& planets) : Module(owner, std::move(name)), planets_(planets) {}

    Knob<bool> on{*this, "on", false, "Camera that flies from one body to the next, instead of the scene's"};
    Knob<float> stay_s{*this, "stay_s", 4.0f, {0.1f, 1000.0f}, "Time at each body", "s"};
    Knob<float> drift_deg{
        *this, "drift_deg", 5.0f, {-90.0f, 90.0f}, "Angle that the camera circles a body by while it stays", "deg"};
    Knob<float> travel_s{*this, "travel_s", 6.0f, {0.1f, 1000.0f}, "Time between two bodies", "s"};

    bool animated() const override { return on; }

    /// Of the camera at a time: where it is, how it is turned, and for which distance from the Sun it is exposed.
    struct Moment {
        glm::dvec3 eye_m{0.0};
        glm::dquat turned{1, 0, 0, 0};  ///< from the camera's axes (it looks along -z) to the world's
        double exposed_for_m = astronomical_unit_m;
        size_t body = 0;       ///< where it stays, or leaves
        double travelled = 0;  ///< 0 to 1 of the way to the next one
    };
    Moment at(double time_s, double days) const;

    /// The camera for a frame, at the origin; gives the planets their other inputs. Put eye_m into View::exact_eye.
    Camera camera(const Moment& moment, const Camera& scene) const;

  private:
    Planets& planets_;
};

struct SolarSystem : World {
    using World::World;
    Planets planets{*this, "planets"};
    Stars stars{*this, "stars", planets};
    Flight flight{*this, "flight", planets};

    Drawings drawings() override { return {stars, planets}; }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"post.tone", "neutral"}, {"bloom.threshold", "1"}};
    }

    // A flight's position exceeds the precision of floats.
    Eye eye(const Frame& frame, const Camera& given) override {
        planets.exposed_for_m.reset();
        if (!flight.on) return {given};
        const double time_s = static_cast<double>(frame.time_s);
        const Flight::Moment moment = flight.at(time_s, planets.days_at(time_s));
        return {flight.camera(moment, given), moment.eye_m};
    }
};

}  // namespace lightwalk
