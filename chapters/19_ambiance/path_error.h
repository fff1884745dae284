// How cameras of a film move, as numbers.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "19_ambiance/timeline.h"

namespace lightwalk {

/// Adds to `error`, over all camera paths of a film: `off_chord`, the greatest distance from the line between two keys, in
/// lengths of that line; `speed`, the largest speed over the smallest, of the path on which that is most.
void measure_paths(const Timeline& film, nlohmann::json& error);

}  // namespace lightwalk
