// Picking with rays, on the processor.
#pragma once
#include "18_playground/exercises.h"
#include "common/scene/scene.h"

namespace lightwalk {

struct Hit {
    uint32_t item;  ///< of Scene::items
    float distance_m;
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
