// Solution of 05.fit_cascade (M. Valient, "Stable Rendering of Cascaded Shadow Maps", ShaderX6, 2008).
#include <algorithm>
#include <cmath>

#include "05_shadow_maps/exercises.h"

namespace lightwalk::solution {

glm::vec2 fit_slice(float tan_half, float aspect, float near_m, float far_m) {
    const float slope_squared = (1.0f + aspect * aspect) * tan_half * tan_half;
    // Centre at equal distances from the corners of both ends, or at the far end.
    const float middle = std::min(0.5f * (near_m + far_m) * (1.0f + slope_squared), far_m);
    const float along = far_m - middle, across_squared = slope_squared * far_m * far_m;
    return {middle, std::sqrt(along * along + across_squared)};
}

glm::vec2 snap_middle(glm::vec2 middle, float texel) { return glm::floor(middle / texel) * texel; }

}  // namespace lightwalk::solution
