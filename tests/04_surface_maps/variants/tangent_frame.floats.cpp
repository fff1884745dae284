// right
#include "04_surface_maps/exercises.h"

namespace lightwalk::exercise {

TangentFrame tangent_frame(const Vertex& a, const Vertex& b, const Vertex& c) {
    const glm::vec3 n = a.normal, e1 = b.position - a.position, e2 = c.position - a.position;
    const glm::vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
    const float determinant = d1.x * d2.y - d2.x * d1.y;
    const glm::vec3 axis = std::fabs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const TangentFrame none{glm::normalize(glm::cross(n, axis)), 1.0f, glm::vec2(0.0f)};
    if (std::fabs(determinant) < 1e-6f || glm::length(glm::cross(e1, e2)) < 1e-6f) return none;
    const glm::vec3 t = (d2.y * e1 - d1.y * e2) / determinant, s = (d1.x * e2 - d2.x * e1) / determinant;
    const glm::vec3 tangent = glm::normalize(t - n * glm::dot(n, t));
    return {tangent, glm::dot(glm::cross(n, tangent), s) < 0 ? -1.0f : 1.0f, {glm::length(t), glm::length(s)}};
}

}  // namespace lightwalk::exercise
