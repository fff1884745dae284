// Ray picking on the CPU.
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
    uint32_t item;
    float distance_m;
    glm::vec3 normal{0.0f};  ///< triangle normal in world space, facing the ray's origin
};

/// Entry distance in metres: 0 if the origin is inside, empty if the ray misses.
std::optional<float> hit_box(const PickRay& ray, const Bounds& box);

/// Distance to a two-sided triangle (T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
/// Journal of Graphics Tools 2(1), 1997), in double precision.
std::optional<double> hit_triangle(const glm::dvec3& origin, const glm::dvec3& direction, const glm::vec3& a,
                                   const glm::vec3& b, const glm::vec3& c);

/// Nearest box or triangle along the ray. Ignores holes cut by textures.
std::optional<Hit> pick_box(const Scene& scene, const PickRay& ray);
std::optional<Hit> pick_triangle(const Scene& scene, const PickRay& ray);

}  // namespace lightwalk
