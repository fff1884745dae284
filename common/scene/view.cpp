#include "common/scene/view.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace lightwalk {

float View::pixel_rad() const { return 2.0f * std::tan(0.5f * camera.fov_y_rad) / static_cast<float>(crop.whole.y); }

uint32_t DerivedViews::of(uint32_t id, uint32_t part) {
    static std::atomic<uint32_t> last{0};
    const auto [found, is_new] = ids_.try_emplace({id, part}, 0u);
    if (is_new) found->second = ++last;
    return found->second;
}

View camera_view(const Camera& camera, const glm::mat4& world_to_clip, glm::uvec2 size, Crop crop) {
    if (crop.whole == glm::uvec2(0)) crop.whole = size;
    return {.view_projection = part_of(crop, size) * world_to_clip,
            .eye = camera.position,
            .camera = camera,
            .size = size,
            .crop = crop};
}

ViewRays view_rays(const View& view) {
    const Camera& camera = view.camera;
    const glm::dvec3 eye(camera.position), back = glm::normalize(eye - glm::dvec3(camera.target));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back)), up = glm::cross(back, right);
    const glm::dvec2 whole(view.crop.whole), first = glm::dvec2(view.crop.origin) + glm::dvec2(view.crop.shift);
    const double pixel = 2 * std::tan(0.5 * double(camera.fov_y_rad)) / whole.y;
    const glm::dvec2 corner = (first - 0.5 * whole) * pixel;
    return {.eye = camera.position,
            .corner = glm::vec3(-back + corner.x * right - corner.y * up),
            .right = glm::vec3(pixel * right),
            .down = glm::vec3(-pixel * up),
            .inverse_near = 1.0f / camera.near_m,
            .inverse_far = 1.0f / camera.far_m};
}

CameraView shader_view(const View& view, const Frame& frame) {
    const int gathered = std::min(frame.gathered + 1, 8);  // longer histories hardly help in motion
    return {.view_projection = view.view_projection,
            .eye = view.eye,
            .time_s = frame.time_s,
            .size = view.size == glm::uvec2(0) ? frame.size : view.size,
            .seed = frame.seed,
            .origin = view.crop.origin,
            .lod_bias = -0.5f * std::log2(static_cast<float>(frame.samples.count * gathered))};
}

void look_from(const View& view, Frame& frame) {
    const CameraView block = shader_view(view, frame);
    const auto bytes = std::as_bytes(std::span(&block, 1));
    frame.globals["view"].assign(bytes.begin(), bytes.end());
}

ViewScope::ViewScope(Frame& frame, const View& view) : frame_(frame), before_(frame.globals["view"]) {
    look_from(view, frame);
}

ViewScope::~ViewScope() { frame_.globals["view"] = std::move(before_); }

glm::mat4 part_of(const Crop& crop, glm::uvec2 size) {
    const glm::vec2 whole(crop.whole), part(size), first = glm::vec2(crop.origin) + crop.shift;
    if (whole == part && first == glm::vec2(0.0f)) return glm::mat4(1.0f);  // avoids rounding
    const glm::vec2 scale = whole / part, offset = (whole - 2.0f * first) / part - 1.0f;
    glm::mat4 m(1.0f);
    m[0][0] = scale.x;
    m[1][1] = scale.y;
    m[3][0] = offset.x;
    m[3][1] = offset.y;
    return m;
}

}  // namespace lightwalk
