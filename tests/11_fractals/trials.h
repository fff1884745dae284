// What the checks of chapter 11 see of an exercise that records a frame.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/check/trial.h"

namespace lightwalk {

struct ConesSeen {
    std::string error;              ///< what it threw; then nothing else is known
    std::string passes;             ///< those of compute: "first, second"
    std::vector<glm::vec4> starts;  ///< texel by texel, from the second of two frames
    std::vector<glm::vec4> found;
    std::string validation;  ///< its first message
};

/// Two frames of so many pixels, with a texel of `starts` for each 8x8 of them. Before each, both images hold -9. A
/// cone writes (its frame, x, y, groups of threads that were dispatched), a march what its tile's start holds, but for
/// the last number, in which it has its own groups.
TRIAL("11.record_cones", ConesSeen, try_record_cones, glm::ivec2 size);

}  // namespace lightwalk
