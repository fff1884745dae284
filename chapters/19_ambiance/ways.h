// Alternative methods for each scene of a film: cost, error against the best, and the sufficient one.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "19_ambiance/reel.h"
#include "common/app/options.h"

namespace lightwalk {

/// Of one scene: a row of ways.json for its kind.
struct Way {
    KnobSettings knobs;
    double error = 0;   ///< greatest mean FLIP against the truth, over three times of the scene
    double gpu_ms = 0;  ///< of a frame: median over these times and three rounds
};

/// All methods of a scene, the most accurate one first, measured in turn as the chapter draws its film: with its
/// anti-aliasing and its samples a pixel. The truth is the first method with 16 times the samples and no
/// anti-aliasing, so that losses between pixels count, too. Afterwards the reel draws the scene by the film's
/// settings.
std::vector<Way> measure_ways(Chapter& chapter, Reel& reel, Gpu& gpu, size_t scene, const Options& options);

/// By the need rule: the cheapest one with an error of at most the budget, or the most accurate if there is none.
struct ChosenWay {
    const Way& way;
    bool enough;
};
ChosenWay cheapest_way(const std::vector<Way>& ways, double budget);

/// Has the reel draw each scene by its cheapest way within options.budget, and says which on standard output; of a
/// scene that has none, too.
void choose_ways(Chapter& chapter, Reel& reel, Gpu& gpu, const Options& options);

/// Writes all scenes' methods as JSON, and the cost of the current film. Returns the exit code. Throws InputError.
int write_ways(Chapter& chapter, Reel& reel, const std::string& file, const Options& options,
               std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
