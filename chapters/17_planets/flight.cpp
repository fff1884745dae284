#include "17_planets/flight.h"

#include <cmath>

namespace lightwalk {
namespace {

// A portrait's camera, from the body's centre: radii away, degrees from the Sun's direction eastwards, and upwards.
struct Stop {
    double radii, around_deg, up_deg;
};
constexpr Stop stops[body_count] = {{4.4, 0, 0},   {4.2, 52, 4},  {4.2, 40, 6},  {4.2, 52, 14},
                                    {4.4, 48, 5},  {4.2, 38, 10}, {4.4, 30, -4}, {7.5, 34, 9},
                                    {5.2, 22, 10}, {4.2, 34, 0},  {4.2, 26, 12}};

struct Pose {
    glm::dvec3 eye, forward;
    double from_body, from_sun;
};

Pose pose_at(size_t body, double days, double drift_deg) {
    const auto id = static_cast<BodyId>(body);
    const Stop& stop = stops[body];
    const glm::dvec3 place = place_body(id, days).position;
    const glm::dvec3 from =
        id == BodyId::sun ? glm::normalize(place_body(BodyId::earth, days).position) : -glm::normalize(place);
    const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), from)), up = glm::cross(from, side);
    const double around = glm::radians(stop.around_deg + drift_deg), high = glm::radians(stop.up_deg);
    const glm::dvec3 away = std::cos(high) * (std::cos(around) * from + std::sin(around) * side) + std::sin(high) * up;
    const double distance = stop.radii * traits(id).radius_m;
    const double from_sun = glm::length(id == BodyId::sun ? place_body(BodyId::mercury, days).position : place);
    return {place + distance * away, -away, distance, from_sun};
}

glm::dquat looking(glm::dvec3 forward) {
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    return glm::quat_cast(glm::dmat3(right, glm::cross(right, forward), -forward));
}

double smooth(double s) { return s * s * s * (s * (6 * s - 15) + 10); }

// Share of the distance travelled after a share `s` of the time: speed grows with the distance from the nearer end,
// so that neither a planet nor the void between takes all of it.
double travelled_at(double s, double near_a, double near_b, double way) {
    const auto half = [&](double share, double near) {
        return near * (std::pow(1 + 0.5 * way / near, share) - 1) / way;
    };
    return s < 0.5 ? half(2 * s, near_a) : 1 - half(2 - 2 * s, near_b);
}

}  // namespace

// [at]
Flight::Moment Flight::at(double time_s, double days) const {
    const double stay = static_cast<double>(stay_s), travel = static_cast<double>(travel_s);
    const double turn = stay + travel, all = turn * static_cast<double>(body_count);
    double t = std::fmod(time_s, all);
    if (t < 0) t += all;
    const size_t body = std::min(static_cast<size_t>(t / turn), body_count - 1), next = (body + 1) % body_count;
    const double within = t - static_cast<double>(body) * turn;
    const auto drift = [&](double s) { return static_cast<double>(drift_deg) * (s / stay - 0.5); };
    if (within <= stay) {
        const Pose pose = pose_at(body, days, drift(within));
        return {pose.eye, looking(pose.forward), pose.from_sun, body, 0};
    }
    const double s = smooth((within - stay) / travel);
    const Pose a = pose_at(body, days, drift(stay)), b = pose_at(next, days, drift(0));
    const double done = travelled_at(s, a.from_body, b.from_body, glm::length(b.eye - a.eye));
    return {glm::mix(a.eye, b.eye, done), glm::slerp(looking(a.forward), looking(b.forward), s),
            std::exp(glm::mix(std::log(a.from_sun), std::log(b.from_sun), s)), body, done};
}
// [/at]

Camera Flight::camera(const Moment& moment, const Camera& scene) const {
    planets_.exposed_for_m = moment.exposed_for_m;
    Camera camera = scene;
    camera.position = glm::vec3(0.0f);
    camera.target = glm::vec3(moment.turned * glm::dvec3(0, 0, -1));
    camera.up = glm::vec3(moment.turned * glm::dvec3(0, 1, 0));
    return camera;
}

}  // namespace lightwalk
