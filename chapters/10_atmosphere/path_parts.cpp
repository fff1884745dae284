#include "10_atmosphere/path_parts.h"

#include <algorithm>
#include <cmath>

#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr double most_rounds = 60000;
constexpr double places_of_a_walk = 8, most_turns = 64;  // as in random_paths.glsl

// After its fifth turn each walk goes on with a chance of 0.8: nine turns are the mean, and of many walks the mean is
// near that. Twenty-four leave room.
constexpr double turns_of_many = 24;

// Steps of delta tracking through all of the air where it is widest: its length in mean free ways of the densest air.
double steps_across(const Air& air) {
    const double top = double(air.top), way = 2 * std::sqrt(top * (2 * double(air.radius) + top));
    double densest = 0;
    for (int c = 0; c < 3; ++c)
        densest = std::max(densest, double(air.rayleigh[c]) + double(air.mie_extinction[c]) + double(air.layer[c]));
    return densest * way;
}

}  // namespace

std::vector<PathPart> path_parts(const PathWork& work, const Air& air) {
    // The round in which a loop ends counts as well.
    const double of_a_turn = 3 + steps_across(air), of_a_place = 2 + work.light_places;
    const double of_a_walk = 2 + places_of_a_walk + turns_of_many * of_a_turn;
    if (work.walks > 0 && most_turns * of_a_turn > most_rounds)
        throw InputError(
            "atmosphere.method: truth with orders multiple takes up to {:.0f} steps for a random walk through this "
            "air, and a driver may end a loop after {:.0f}; reduce the scattering coefficients or top_m, or set orders "
            "to single",
            most_turns * of_a_turn, most_rounds);
    if (work.walks * of_a_walk + work.places * of_a_place <= most_rounds)
        return {{.end_walk = work.walks, .end_place = work.places, .begins = 1, .ends = 1}};
    std::vector<PathPart> parts;
    const auto most_walks = std::max(1, static_cast<int>(most_rounds / of_a_walk));
    for (int first = 0; first < work.walks; first += most_walks)
        parts.push_back({.first_walk = first, .end_walk = std::min(first + most_walks, work.walks)});
    const auto most_places = std::max(1, static_cast<int>(most_rounds / of_a_place));
    for (int first = 0; first < work.places; first += most_places)
        parts.push_back({.first_place = first, .end_place = std::min(first + most_places, work.places)});
    parts.front().begins = 1;
    parts.back().ends = 1;
    return parts;
}

}  // namespace lightwalk
