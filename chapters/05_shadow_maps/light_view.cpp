#include "05_shadow_maps/light_view.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "05_shadow_maps/exercises.h"

namespace lightwalk {
namespace {

glm::vec3 any_across(glm::vec3 direction) {
    return std::abs(direction.y) < 0.99f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
}

// World to light space, looking along -z.
glm::mat4 look_along(glm::vec3 eye, glm::vec3 direction, glm::vec3 up) { return glm::lookAt(eye, eye + direction, up); }

// Perspective projection with depth 1 at `near`, 0 at `far`; y down.
glm::mat4 perspective(float tan_half, float near, float far) {
    glm::mat4 m(0.0f);
    m[0][0] = 1.0f / tan_half;
    m[1][1] = -1.0f / tan_half;
    m[2][2] = near / (far - near);
    m[3][2] = far * near / (far - near);
    m[2][3] = -1.0f;
    return m;
}

glm::mat4 parallel(float half_width, float near, float far) {
    glm::mat4 m(1.0f);
    m[0][0] = 1.0f / half_width;
    m[1][1] = -1.0f / half_width;
    m[2][2] = 1.0f / (far - near);
    m[3][2] = far / (far - near);
    return m;
}

LightView finish(LightView v) {
    v.data.to_clip = v.view.view_projection;
    v.data.plane_to_clip = glm::transpose(glm::inverse(v.view.view_projection));
    v.data.layer = NO_LAYER;
    return v;
}

LightView perspective_view(glm::vec3 eye, glm::vec3 direction, glm::vec3 up, float tan_half, float far,
                           const LightViewOptions& options) {
    // Margin around the view, so that filters at its edge read its own depths.
    const float wide = tan_half / (1.0f - 2.0f * MAP_MARGIN), near = std::min(options.near_m, 0.02f * far);
    const glm::mat4 look = look_along(eye, direction, up);
    LightView v{.view = {perspective(wide, near, far) * look, eye},
                .casters = perspective(wide, 1e-3f * near, far) * look,  // casters in front of the near plane count too
                .data = {}};
    v.data.near = near;
    v.data.far = far;
    v.data.to_distance = {1.0f / far, 1.0f / near - 1.0f / far};
    v.data.perspective = 1;
    v.data.texel = 2.0f * wide / static_cast<float>(options.resolution);
    return finish(v);
}

std::vector<LightView> point_views(const Light& light, float far, const LightViewOptions& options) {
    std::vector<LightView> views;
    for (int face = 0; face < 6; ++face) {
        glm::vec3 direction(0.0f), up(0.0f, 1.0f, 0.0f);
        direction[face / 2] = face % 2 ? -1.0f : 1.0f;
        if (face / 2 == 1) up = {0.0f, 0.0f, 1.0f};
        views.push_back(perspective_view(light.position, direction, up, 1.0f, far, options));
    }
    return views;
}

struct Ball {
    glm::vec3 center{0.0f};
    float radius = 0;
};

Ball ball_around(const Bounds& box) { return {box.center(), 0.5f * glm::length(box.extent())}; }

// Distance at which cascade i of `count` ends, metres: F. Zhang et al., "Parallel-Split Shadow Maps for Large-Scale Virtual
// Environments", VRCIA 2006, section 3.
float cascade_split(float near_m, float far_m, int i, int count, float lambda) {
    if (i >= count) return far_m;  // exact, regardless of rounding in powers
    const float t = static_cast<float>(i) / static_cast<float>(count);
    const float uniform = near_m + (far_m - near_m) * t;
    const float logarithmic = near_m * std::pow(far_m / near_m, t);
    return uniform + lambda * (logarithmic - uniform);
}

// Bounding sphere of the camera's view between two depths; its size does not depend on the camera's rotation. Aspect ratio
// of 2 at most, so that cascades do not depend on the window.
Ball ball_around_slice(const Camera& camera, float near, float far) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec2 fitted = fit_slice(std::tan(0.5f * camera.fov_y_rad), 2.0f, near, far);
    return {camera.position + fitted.x * forward, fitted.y};
}

// Nearest and farthest distance of the scene along a light's direction, with a gap.
std::pair<float, float> range_along(const glm::mat4& turn, const Bounds& scene) {
    float near = 1e30f, far = -1e30f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const float depth = -(turn * glm::vec4(glm::mix(scene.lower, scene.upper, pick), 1.0f)).z;
        near = std::min(near, depth);
        far = std::max(far, depth);
    }
    const float gap = std::max(1e-3f * (far - near), 1e-3f);
    return {near - gap, far + gap};
}

// [snap]
// View of a sphere, from outside the scene. `snap`: its centre moves by whole texels along the light's axes, so that
// texel edges stay fixed in the world.
LightView parallel_view(glm::vec3 direction, Ball ball, const Bounds& scene, const LightViewOptions& options) {
    const float half_width = ball.radius / (1.0f - 2.0f * MAP_MARGIN);
    const float texel = 2.0f * half_width / static_cast<float>(options.resolution);
    const glm::mat4 turn = look_along(glm::vec3(0.0f), direction, any_across(direction));
    glm::vec3 middle(turn * glm::vec4(ball.center, 1.0f));
    if (options.snap) middle = glm::vec3(snap_middle(glm::vec2(middle), texel), middle.z);
    const auto [near, far] = range_along(turn, scene);
    const glm::mat4 move = glm::translate(glm::mat4(1.0f), {-middle.x, -middle.y, 0.0f});
    LightView v{.view = {parallel(half_width, near, far) * move * turn, -near * direction}, .casters{}, .data = {}};
    v.casters = v.view.view_projection;
    v.data.near = near;
    v.data.far = far;
    v.data.to_distance = {far, near - far};
    v.data.texel = texel;
    return finish(v);
}
// [/snap]

std::vector<LightView> cascades(const Light& light, const Bounds& scene, const Camera& camera,
                                const LightViewOptions& options) {
    const Ball all = ball_around(scene);
    const float far = std::min(camera.far_m, std::max(options.distance_m, 1.01f * camera.near_m));
    std::vector<LightView> views;
    float from = camera.near_m;
    for (int i = 0; i < options.cascades; ++i) {
        const float to = cascade_split(camera.near_m, far, i + 1, options.cascades, options.split);
        Ball ball = ball_around_slice(camera, from, to);
        from = to;
        // Scenes smaller than their slice are covered as a whole.
        const bool whole = ball.radius >= all.radius;
        if (whole) ball = all;
        views.push_back(parallel_view(glm::normalize(light.direction), ball, scene, options));
        views.back().whole = whole;
        if (whole) break;
    }
    return views;
}

}  // namespace

float farthest_corner(const Bounds& box, glm::vec3 from) {
    return glm::length(glm::max(glm::abs(from - box.lower), glm::abs(from - box.upper)));
}

// A directional light's shadow is as wide as its caster. Points whose filters reach the coarser map's shadow lie in the
// part of this map that view_of() of 05_shadow_maps/shadow.glsl selects.
bool holds_shadow_of(const LightView& cascade, const Bounds& box, float texel) {
    if (box.empty() || cascade.data.perspective == 1) return false;
    const glm::mat4& to_clip = cascade.data.to_clip;
    const glm::vec2 middle(to_clip * glm::vec4(box.center(), 1.0f));
    glm::vec2 half(0.0f);
    for (int axis = 0; axis < 3; ++axis) half += glm::abs(glm::vec2(to_clip[axis])) * (0.5f * box.extent()[axis]);
    const float reach = 2.0f * MAP_MARGIN * texel / cascade.data.texel;  // clip space is 2 wide
    return glm::all(glm::lessThanEqual(glm::abs(middle) + half, glm::vec2(1.0f - 2.0f * MAP_MARGIN - reach)));
}

std::vector<LightView> light_views(const Light& light, float reach_m, const Bounds& scene, const Camera& camera,
                                   const LightViewOptions& options) {
    if (light.kind == Light::Kind::directional) return cascades(light, scene, camera, options);
    const float far = std::max(std::min(reach_m, farthest_corner(scene, light.position)), 1e-3f);
    if (light.kind == Light::Kind::point || light.outer_rad > widest_view_rad) return point_views(light, far, options);
    return {perspective_view(light.position, light.direction, any_across(light.direction),
                             std::tan(std::max(light.outer_rad, 1e-2f)), far, options)};
}

}  // namespace lightwalk
