#include <cmath>
#include <cstdio>
#include <limits>

#include "01_obj/truth.h"
#include "checks.h"

namespace lightwalk {
namespace {

std::string show(const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.5g, %.5g, %.5g)", v.x, v.y, v.z);
    return text;
}

}  // namespace

Failures check_view_projection(glm::mat4 (*attempt)(const Camera&, float)) {
    Failures failures;
    const float infinity = std::numeric_limits<float>::infinity();
    const Camera cameras[] = {
        {},
        {.position = {3, 2, 5}, .target = {0.5f, 0, -1}, .fov_y_rad = 1.2f, .near_m = 0.1f, .far_m = 50.0f},
        {.position = {-4, 9, 2}, .target = {1, 1, 1}, .up = {0.2f, 3, 0.1f}, .fov_y_rad = 0.3f, .far_m = infinity},
        {.position = {0, 0, -3}, .up = {1, 0, 0}, .fov_y_rad = 2.0f, .near_m = 0.01f, .far_m = 1e6f}};
    int number = 0;
    for (const Camera& camera : cameras) {
        ++number;
        const glm::vec3 forward = glm::normalize(camera.target - camera.position);
        const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
        const auto place = [&](float x, float y, float z) {
            return camera.position + x * right + y * up + z * forward;
        };
        const float middle = glm::length(camera.target - camera.position);
        const float far_m = std::isinf(camera.far_m) ? 1e7f : camera.far_m;
        const std::pair<const char*, glm::vec3> points[] = {
            {"the target", camera.target},
            {"a point to the right of the target", place(0.3f, 0, middle)},
            {"a point above the target", place(0, 0.3f, middle)},
            {"a point on the near plane", place(0, 0, camera.near_m)},
            {"a point on the far plane", place(0, 0, far_m)},
            {"a point off the middle", place(-1.0f, 0.7f, 2.5f * middle)}};
        for (const float aspect : {1.0f, 16.0f / 9.0f, 0.5f})
            for (const auto& [what, point] : points) {
                const glm::vec4 clip = attempt(camera, aspect) * glm::vec4(point, 1.0f);
                const glm::dvec3 got = glm::dvec3(clip) / static_cast<double>(clip.w);
                const glm::dvec3 right_place = truth::project(camera, aspect, point);
                if (clip.w > 0.0f && glm::length(got - right_place) <= 2e-3) continue;
                failures.push_back("view_projection: camera " + std::to_string(number) + ", aspect " +
                                   std::to_string(aspect) + ", " + what + " appears at " + show(got) + " with w = " +
                                   std::to_string(clip.w) + ", expected " + show(right_place) + " and w above 0");
            }
    }
    return failures;
}

}  // namespace lightwalk
