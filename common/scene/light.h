// A light as a scene file states it.
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
    float intensity = 1.0f;                    ///< at the surface (directional) or at 1 m; 0 to 1e6
    glm::vec3 position{0.0f};                  ///< metres; point and spot
    glm::vec3 direction{0.0f, -1.0f, 0.0f};    ///< the way the light travels; directional and spot
    float range_m = 10.0f;                     ///< beyond it a ranged falloff is 0; point and spot; above or equal 0
    float inner_rad = 0.3f, outer_rad = 0.5f;  ///< half angles of a spot's cone, 0 <= inner <= outer <= pi
    float softness = 0.5f;                     ///< 0 linear to 1 soft
    bool shadow = false;                       ///< casts shadows
    float size_m = 0.0f;     ///< diameter of the disc-shaped lamp, which faces the receiver; point and spot
    float size_rad = 0.0f;   ///< how wide the lamp looks from here, as the sun; directional
    glm::vec3 tube_m{0.0f};  ///< from one end of a tube-shaped lamp to the other; no length: a disc; point
    std::string name{};      ///< for people; may be empty
    bool locked = false;     ///< not changed in an editor
    bool operator==(const Light&) const = default;
};

/// Lights that no longer change: one list is equal to itself without comparing a million lights.
using LightList = std::shared_ptr<const std::vector<Light>>;

}  // namespace lightwalk
