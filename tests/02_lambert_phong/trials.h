// What the checks of chapter 02 see of an exercise that records a frame.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/check/trial.h"

namespace lightwalk {

struct MistFrame {
    std::string error;   ///< what it threw; then nothing else is known
    std::string passes;  ///< "sky (compute), shade (raster), ..."
    int draws = 0;
    glm::vec3 left{0.0f}, right{0.0f};  ///< linear light, of a pixel in either half
};

struct MistSeen {
    std::vector<MistFrame> frames;
    std::string validation;  ///< its first message
};

/// Two frames of 16x16 pixels: the scene, as red as it says, covers the left half, then the right one, at depth 0.5;
/// the sky is blue; mist adds green by the depth that it finds. Before each, a frame leaves the nearest depth and dark
/// green.
TRIAL("02.record_mist", MistSeen, try_record_mist, float red, float blue);

}  // namespace lightwalk
