// What the sky sheds on level ground.
#pragma once
#include <vector>

#include "10_atmosphere/air_data.h"

namespace lightwalk {

/// What light scattered once sheds on level ground at a height of 0, in the unit of air.sun, for sun cosines x |x| with
/// x from -1 to 1 in equal steps. By eight times six directions of the upper half of the sky, each in 16 samples,
/// sunlight by Smith and Smith's fit; in double precision, in some milliseconds.
std::vector<glm::vec3> skylight_table(const Air& air);

}  // namespace lightwalk
