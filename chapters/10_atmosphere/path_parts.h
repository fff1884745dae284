// Division of the paths of a picture into several dispatches, where one would take too long.
#pragma once
#include <vector>

#include "10_atmosphere/air_data.h"
#include "10_atmosphere/path_part.h"

namespace lightwalk {

/// The work on each path.
struct PathWork {
    int places = 1;        ///< for light scattered once, 1 or more
    int light_places = 1;  ///< from each of them towards the sun
    int walks = 0;         ///< random ones, for light scattered more often
};

/// In order, one part if possible. llvmpipe ends all loops of an invocation after 65,535 iterations together, and
/// returns their intermediate results. Throws InputError if a single random walk may take longer.
std::vector<PathPart> path_parts(const PathWork& work, const Air& air);

}  // namespace lightwalk
