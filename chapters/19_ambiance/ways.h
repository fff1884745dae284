// The ways in which each scene of a film can be drawn: what they cost, how far they are from the best, which one is enough.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "19_ambiance/reel.h"
#include "common/app/options.h"

namespace lightwalk {

// [ways]
/// Of one scene: a row of ways.json for its kind.
struct Way {
    KnobSettings knobs;
    double error = 0;   ///< greatest mean FLIP against the first way, over three times of the scene
    double gpu_ms = 0;  ///< of a frame: median over these times and three rounds
};

/// All ways of a scene, the most accurate one first, measured in turn. The reel then draws it as the film says.
std::vector<Way> measure_ways(Reel& reel, Gpu& gpu, size_t scene, const Options& options);

/// The cheapest of those whose error is at most the budget; the first one's is 0.
const Way& cheapest_way(const std::vector<Way>& ways, double budget);

/// Has the reel draw each scene by its cheapest way within options.budget, and says which on standard output.
void choose_ways(Reel& reel, Gpu& gpu, const Options& options);

/// Writes all scenes' ways as JSON, and what the film as it stands costs. Returns the exit code. Throws InputError.
int write_ways(Chapter& chapter, Reel& reel, const std::string& file, const Options& options,
               std::unique_ptr<Gpu>& gpu);
// [/ways]

}  // namespace lightwalk
