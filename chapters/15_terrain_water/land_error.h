// Error of the ground's geometry on the screen, for the study.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "15_terrain_water/land.h"
#include "common/app/chapter.h"

namespace lightwalk {

/// Renders the chapter as it is set and by rays, and adds to `error`: screen_error_px, how far the surface lies from the
/// rays' along its normal, in pixels, on average over pixels in which both find ground; screen_error_p99_px, its 99th
/// percentile; misjudged, the share of pixels in which one of the two finds ground; and triangles.
void measure_land(Chapter& chapter, Land& land, Gpu& gpu, glm::uvec2 size, nlohmann::json& error);

}  // namespace lightwalk
