// Views of a scene from its lights.
#pragma once
#include "05_shadow_maps/shadow_data.h"
#include "common/scene/camera.h"
#include "common/scene/light.h"
#include "common/scene/mesh.h"
#include "common/scene/view.h"

namespace lightwalk {

/// View from a light, with its shader data, whose layer is set later.
struct LightView {
    View view;
    glm::mat4 casters;  ///< world to a clip space that contains all possible casters
    ShadowView data;
    bool whole = false;  ///< cascade of the whole scene, independent of the camera
};

/// Settings of light views.
struct LightViewOptions {
    int resolution = 1024;     ///< width of a map, texels
    float near_m = 0.05f;      ///< near plane of point and spot lights, metres
    int cascades = 3;          ///< cascades per directional light, 1 to 4
    float split = 0.5f;        ///< cascade_split()'s lambda
    float distance_m = 30.0f;  ///< range of the cascades from the eye, metres
    bool snap = true;          ///< moves cascades by whole texels
    bool operator==(const LightViewOptions&) const = default;
};

/// Distance from a point to the farthest corner of the box, metres.
float farthest_corner(const Bounds& box, glm::vec3 from);

/// Whether all receivers of the world-space box's shadow use this cascade or a finer one, so that a coarser one, with
/// texels of `texel` metres, can skip the box.
bool holds_shadow_of(const LightView& cascade, const Bounds& box, float texel);

/// Half angle above which a spot light uses six views, like a point light.
constexpr float widest_view_rad = 1.1f;

/// Views of a light over the world-space box `scene` (not empty); `reach_m`: range of point and spot lights.
/// Directional lights have one view per cascade, nearest first, up to the first cascade that would contain the whole
/// scene.
std::vector<LightView> light_views(const Light& light, float reach_m, const Bounds& scene, const Camera& camera,
                                   const LightViewOptions& options);

}  // namespace lightwalk
