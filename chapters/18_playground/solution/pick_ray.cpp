#include "18_playground/exercises.h"

namespace lightwalk::solution {

// Double precision, since the near plane may be at a hundred thousandth of the picked distance.
PickRay pick_ray(const glm::mat4& clip_to_world, glm::vec2 cursor_px, glm::uvec2 size) {
    const glm::dvec2 clip = 2.0 * glm::dvec2(cursor_px) / glm::dvec2(size) - 1.0;
    const auto at_depth = [&](double depth) {
        const glm::dvec4 place = glm::dmat4(clip_to_world) * glm::dvec4(clip, depth, 1.0);
        return glm::dvec3(place) / place.w;
    };
    const glm::dvec3 near = at_depth(1.0);
    return {glm::vec3(near), glm::vec3(glm::normalize(at_depth(0.5) - near))};
}

}  // namespace lightwalk::solution
