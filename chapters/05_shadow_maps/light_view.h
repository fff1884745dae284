// Views of a scene from its lights.
#pragma once
#include "05_shadow_maps/shadow_data.h"
#include "common/scene/camera.h"
#include "common/scene/light.h"
#include "common/scene/mesh.h"
#include "common/scene/view.h"

namespace lightwalk {

/// A light's view, and the shader's part of it, still without its layer.
struct LightView {
    View view;
    glm::mat4 casters;  ///< world to a clip space that contains all possible casters
    ShadowView data;
    bool whole = false;  ///< a cascade that holds the whole scene, wherever the camera is
};

/// Settings common to a frame's views.
struct LightViewOptions {
    int resolution = 1024;     ///< texels of a map's side
    float near_m = 0.05f;      ///< of a point's or a spot's view
    int cascades = 3;          ///< of a directional light, 1 to 4
    float split = 0.5f;        ///< cascade_split()'s lambda
    float distance_m = 30.0f;  ///< from the eye to which cascades reach
    bool snap = true;          ///< a cascade moves by whole texels
    bool operator==(const LightViewOptions&) const = default;
};

/// How far the farthest corner of the box is from a point, in metres.
float farthest_corner(const Bounds& box, glm::vec3 from);

/// Whether all that the box (world space) casts a shadow on is asked for in this cascade or a finer one. Then a coarser one,
/// which has texels of `texel` metres, does well without the box.
bool holds_shadow_of(const LightView& cascade, const Bounds& box, float texel);

/// A spot wider than this (half angle) is seen in six views, as a point light is.
constexpr float widest_view_rad = 1.1f;

/// The views of a light that reaches `reach_m` (point and spot) over a scene within `scene` (world space, not empty).
/// A directional light has a view for each cascade of the camera's view, the nearest first; a cascade that would hold
/// the whole scene is the last.
std::vector<LightView> light_views(const Light& light, float reach_m, const Bounds& scene, const Camera& camera,
                                   const LightViewOptions& options);

}  // namespace lightwalk
