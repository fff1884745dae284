#include "17_planets/exercises.h"

namespace lightwalk::solution {

// Subtract first, where the digits are; then round.
glm::mat4 camera_relative(const glm::dmat4& object_to_world, const glm::dvec3& camera_m) {
    glm::dmat4 relative = object_to_world;
    relative[3] -= glm::dvec4(camera_m, 0.0);
    return glm::mat4(relative);
}

}  // namespace lightwalk::solution
