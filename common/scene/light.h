// Light sources of scene files.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace lightwalk {

struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    glm::vec3 color{1.0f};                     ///< linear, 0 to 1
    float intensity = 1.0f;                    ///< value at the surface (directional) or at 1 m; 0 to 1e6
    glm::vec3 position{0.0f};                  ///< metres; point, spot
    glm::vec3 direction{0.0f, -1.0f, 0.0f};    ///< direction of propagation; directional, spot
    float range_m = 10.0f;                     ///< cut-off of ranged falloffs, >= 0; point, spot
    float inner_rad = 0.3f, outer_rad = 0.5f;  ///< half angles of the cone, 0 <= inner <= outer <= pi; spot
    float softness = 0.5f;                     ///< cone edge, 0 linear to 1 soft; spot
    bool shadow = false;
    float size_m = 0.0f;     ///< diameter of a disc facing the receiver; point, spot
    float size_rad = 0.0f;   ///< angular diameter; directional
    glm::vec3 tube_m{0.0f};  ///< axis of a tube light, end to end; zero: a disc; point
    std::string name{};
    bool locked = false;
    bool operator==(const Light&) const = default;
};

/// Immutable light list: comparing pointers avoids comparing up to a million lights.
using LightList = std::shared_ptr<const std::vector<Light>>;

}  // namespace lightwalk
