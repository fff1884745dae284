// What the checks of chapter 14 see of an exercise that records a frame.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/check/trial.h"

namespace lightwalk {

struct FacesSeen {
    std::string error;              ///< what it threw; then nothing else is known
    std::string passes;             ///< those of compute: "first, second"
    std::vector<glm::vec4> texels;  ///< level by level, face by face, row by row
    std::string validation;         ///< its first message
};

/// Two frames with a cube of so many texels and levels, which before each holds -9. The filter writes (1 + face,
/// roughness, groups of threads, what `radiance` holds: 1, or 2 in the second frame).
TRIAL("14.prefilter_faces", FacesSeen, try_prefilter_faces, uint32_t texels, uint32_t levels);

}  // namespace lightwalk
