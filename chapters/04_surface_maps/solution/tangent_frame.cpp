// Solution of 04.tangent_frame (E. Lengyel, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh", 2001).
#include "04_surface_maps/exercises.h"

namespace lightwalk::solution {
namespace {

// A unit vector perpendicular to the normal, made from the axis least aligned with it.
glm::vec3 perpendicular(glm::vec3 normal) {
    const glm::vec3 size = glm::abs(normal);
    const glm::vec3 axis = size.x <= size.y && size.x <= size.z ? glm::vec3(1, 0, 0)
                           : size.y <= size.z                   ? glm::vec3(0, 1, 0)
                                                                : glm::vec3(0, 0, 1);
    return glm::normalize(axis - normal * glm::dot(normal, axis));
}

}  // namespace

TangentFrame tangent_frame(const Vertex& a, const Vertex& b, const Vertex& c) {
    // In doubles, texture coordinates that differ in their last bits still have a determinant.
    const glm::dvec3 e1 = glm::dvec3(b.position) - glm::dvec3(a.position);
    const glm::dvec3 e2 = glm::dvec3(c.position) - glm::dvec3(a.position);
    // A triangle as thin as the rounding of its corners has no usable direction.
    const bool has_area = glm::length(glm::cross(e1, e2)) > 1e-6 * std::max(glm::dot(e1, e1), glm::dot(e2, e2));
    const glm::dvec2 uv1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), uv2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    const TangentFrame none{.tangent = perpendicular(a.normal), .handedness = 1.0f, .metres_per_uv = {0.0f, 0.0f}};
    if (!has_area || !(std::fabs(determinant) > 1e-9 * glm::length(uv1) * glm::length(uv2))) return none;
    const glm::dvec3 per_u = (uv2.y * e1 - uv1.y * e2) / determinant;
    const glm::dvec3 per_v = (uv1.x * e2 - uv2.x * e1) / determinant;
    const glm::dvec3 normal(a.normal);
    const glm::dvec3 in_surface = per_u - normal * glm::dot(normal, per_u);
    if (!(glm::length(in_surface) > 1e-6 * glm::length(per_u))) return none;
    const glm::dvec3 tangent = glm::normalize(in_surface);
    return {.tangent = glm::vec3(tangent),
            .handedness = glm::dot(glm::cross(normal, tangent), per_v) < 0.0 ? -1.0f : 1.0f,
            .metres_per_uv = glm::vec2(glm::length(per_u), glm::length(per_v))};
}

}  // namespace lightwalk::solution
