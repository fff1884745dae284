// What a camera sees of a scene at a few points of the picture, found on the CPU.
#pragma once
#include <vector>

#include "common/scene/scene.h"

namespace lightwalk {

struct VisiblePoint {
    glm::vec3 position{0.0f};  ///< metres, world space
    glm::vec3 normal{0.0f};    ///< unit length, interpolated between vertices
    float depth_m = 0;         ///< along the view
    uint32_t item = 0;         ///< which of the scene's draw calls
};

/// The nearest front face under the middle of each cell of a grid over the picture; nothing where a ray hits none.
std::vector<VisiblePoint> visible_points(const Scene& scene, const Camera& camera, float aspect, glm::uvec2 grid);

}  // namespace lightwalk
