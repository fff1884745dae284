// What the checks of chapter 12 see of an exercise that records a frame.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/check/trial.h"

namespace lightwalk {

struct SkinChain {
    std::string error;              ///< what it threw; then nothing else is known
    int passes = 0;                 ///< compute passes called "skin blur"
    std::vector<glm::vec4> levels;  ///< two texels of each, the first and the last
    glm::vec4 irradiance{0.0f};     ///< its first texel
    std::string validation;         ///< its first message
};

/// A chain of `count` Gaussians over 20x12 texels. Each line adds half of the variance it is told to red, green and
/// blue, so that both directions together add all of it; and to alpha 1 for u, 32 for v, 1024 where smooth_mm is not
/// what the texels say of themselves, 4096 where the stretch is not the stretch. Levels held -9 in alpha before.
TRIAL("12.blur_irradiance", SkinChain, try_blur_irradiance, int count);

}  // namespace lightwalk
