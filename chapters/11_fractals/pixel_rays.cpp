#include "11_fractals/pixel_rays.h"

namespace lightwalk {

PixelRays pixel_rays(const Camera& camera, const Frame& frame) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up)), down = glm::cross(forward, right);
    const glm::vec2 whole(frame.crop.whole), shift = glm::vec2(frame.crop.origin) + frame.crop.shift + 0.5f;
    const float pixel = 2.0f * std::tan(0.5f * camera.fov_y_rad) / whole.y;  // at a distance of 1
    const glm::vec2 first = pixel * (shift - 0.5f * whole);
    return {.eye = camera.position,
            .first = forward + first.x * right + first.y * down,
            .right = pixel * right,
            .down = pixel * down,
            .pixel_rad = pixel};
}

}  // namespace lightwalk
