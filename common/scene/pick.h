// Picking with rays, on the processor.
#pragma once
#include <optional>

#include "common/scene/scene.h"

namespace lightwalk {

// [pick_ray_types]
/// The ray behind a pixel: metres, world space; `direction` has unit length.
struct PickRay {
    glm::vec3 origin{0.0f}, direction{0.0f, 0.0f, -1.0f};
};
// [/pick_ray_types]

struct Hit {
    uint32_t item;  ///< of Scene::items
    float distance_m;
    glm::vec3 normal{0.0f};  ///< of a triangle, in the world, on the side of the ray's origin
};

/// Where the ray enters the box, in metres: 0 where it begins inside; nothing where it misses.
std::optional<float> hit_box(const PickRay& ray, const Bounds& box);

/// Distance to a triangle, from either side (T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
/// Journal of Graphics Tools 2(1), 1997), in double precision.
std::optional<double> hit_triangle(const glm::dvec3& origin, const glm::dvec3& direction, const glm::vec3& a,
                                   const glm::vec3& b, const glm::vec3& c);

/// The nearest box, or the nearest triangle: tests items by box distance, until no box is nearer than the hit.
/// Ignores holes cut by textures.
std::optional<Hit> pick_box(const Scene& scene, const PickRay& ray);
std::optional<Hit> pick_triangle(const Scene& scene, const PickRay& ray);

}  // namespace lightwalk
