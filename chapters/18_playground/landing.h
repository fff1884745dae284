// Where a new model or light is put: on the surface that a pixel of the picture shows.
#pragma once
#include "15_terrain_water/ground_heights.h"
#include "18_playground/placement.h"
#include "common/scene/pick.h"
#include "common/scene/view.h"

namespace lightwalk {

struct Landing {
    glm::vec3 point{0.0f}, normal{0.0f, 1.0f, 0.0f};  ///< metres, world space; the normal points to the viewer
    float distance_m = 1;                             ///< from the eye
};

/// Behind the picture's edge, or far away, the ground below the scene; where there is none, a point at the distance of
/// the camera's target.
Landing landing_on(const Scene& scene, const Camera& camera, const PickRay& ray, const GroundHeights& terrain = {});

/// A model whose box touches the surface from outside. One that the view could not show keeps its shape, not its size.
Placement placed_model(const Landing& landing, const Camera& camera, const Bounds& box);

/// A lamp above the surface, halfway to what is opposite at most, in the picture, and at a place of its own.
Light placed_light(Light::Kind kind, const Landing& landing, const Scene& scene, const View& view);

}  // namespace lightwalk
