// Solar system world: planets before the stars, seen from the scene's camera or on a flight.
#pragma once
#include "17_planets/flight.h"
#include "17_planets/stars.h"
#include "common/app/world.h"

namespace lightwalk {

// [solar_system]
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
// [/solar_system]

}  // namespace lightwalk
