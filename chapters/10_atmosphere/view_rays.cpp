#include "10_atmosphere/view_rays.h"

#include <cmath>

namespace lightwalk {

ViewRays view_rays(const Camera& camera, const Frame& frame) {
    const glm::dvec3 eye(camera.position), back = glm::normalize(eye - glm::dvec3(camera.target));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back)), up = glm::cross(back, right);
    const glm::dvec2 whole(frame.crop.whole), first = glm::dvec2(frame.crop.origin) + glm::dvec2(frame.crop.shift);
    const double pixel = 2 * std::tan(0.5 * double(camera.fov_y_rad)) / whole.y;
    const glm::dvec2 corner = (first - 0.5 * whole) * pixel;
    return {.eye = camera.position,
            .corner = glm::vec3(-back + corner.x * right - corner.y * up),
            .right = glm::vec3(pixel * right),
            .down = glm::vec3(-pixel * up),
            .inverse_near = 1.0f / camera.near_m,
            .inverse_far = 1.0f / camera.far_m};
}

}  // namespace lightwalk
