// Heights of the ground on the processor, for rays.
#pragma once
#include <optional>

#include "15_terrain_water/ground.h"
#include "common/scene/pick.h"

namespace lightwalk {

// [ground_heights]
struct GroundHeights {
    LandMap map{};
    std::vector<float> heights_m{};  ///< row by row; none: there is no ground

    /// Height at world x and z, linear between samples; nothing beside the map.
    std::optional<float> height_at(const glm::dvec2& place) const;
    struct Met {
        float distance_m;
        glm::vec3 normal;
    };
    /// Where the ray enters the ground from above, within `most_m`: found in steps of half a sample, then by bisection.
    std::optional<Met> met_by(const PickRay& ray, float most_m) const;
};

/// The heights as the device has made them. Waits: not within a frame.
GroundHeights read_heights(Gpu& gpu, const Ground& ground);
// [/ground_heights]

}  // namespace lightwalk
