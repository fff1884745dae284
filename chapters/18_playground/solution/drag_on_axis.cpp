#include <algorithm>

#include "18_playground/exercises.h"

namespace lightwalk::solution {

float drag_on_axis(const PickRay& ray, glm::vec3 pivot, glm::vec3 axis) {
    constexpr double least = 0.030153689607045808;  // sin² 10°
    const glm::dvec3 d(ray.direction), w = glm::dvec3(ray.origin) - glm::dvec3(pivot);
    const glm::dvec3 c = glm::cross(glm::dvec3(axis), d);
    return static_cast<float>(glm::dot(c, glm::cross(w, d)) / std::max(glm::dot(c, c), least));
}

}  // namespace lightwalk::solution
