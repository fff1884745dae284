// A flight through the solar system: the camera as a function of time.
#pragma once
#include <glm/gtc/quaternion.hpp>

#include "17_planets/planets.h"

namespace lightwalk {

// [flight]
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
    // [/flight]

  private:
    Planets& planets_;
};

}  // namespace lightwalk
