#include <cmath>
#include <cstdio>
#include <limits>

#include "01_obj/exercises.h"
#include "01_obj/truth.h"
#include "common/check/check.h"

namespace lightwalk {
namespace {

std::string show(const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.5g, %.5g, %.5g)", v.x, v.y, v.z);
    return text;
}

std::string place_text(const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "x = %.5g, y = %.5g, depth %.5g", v.x, v.y, v.z);
    return text;
}

// Probable cause of a misplaced point.
std::string hint_for(const glm::dvec4& clip, const glm::dvec3& got, const glm::dvec3& right) {
    const auto near = [](double a, double b) { return std::abs(a - b) <= 5e-4; };
    if (!(clip.w > 0)) return "w must be the distance in front of the camera, -z in its space, and above 0 there";
    if (near(got.x, right.x) && near(got.y, -right.y) && !near(right.y, 0)) return "y points down on Vulkan's screen";
    if (near(got.x, right.x) && near(got.y, right.y))
        return "the place on the screen is right, the depth is not: it is 1 at the near plane and 0 at the far one; "
               "solve "
               "those two equations for a and b";
    if (near(got.y, right.y)) return "only x is wrong: by the aspect, or by which way the camera's x axis points";
    return "first the camera's axes: the target must land in the middle; then the projection: f = 1 / tan(fov_y / 2)";
}

}  // namespace

CHECK_EXERCISE("01.view_projection",
               "write down where the near and the far plane must land, and solve for two numbers") {
    const float infinity = std::numeric_limits<float>::infinity();
    const Camera cameras[] = {
        {},
        {.position = {3, 2, 5}, .target = {0.5f, 0, -1}, .fov_y_rad = 1.2f, .near_m = 0.1f, .far_m = 50.0f},
        {.position = {-4, 9, 2}, .target = {1, 1, 1}, .up = {0.2f, 3, 0.1f}, .fov_y_rad = 0.3f, .far_m = infinity},
        {.position = {0, 0, -3}, .up = {1, 0, 0}, .fov_y_rad = 2.0f, .near_m = 0.01f, .far_m = 1e6f}};
    for (const Camera& camera : cameras) {
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
                char shape[32];
                std::snprintf(shape, sizeof shape, "%.3g", static_cast<double>(aspect));
                const std::string call = "view_projection for a camera at " + show(camera.position) +
                                         " that looks at " + show(camera.target) + " with aspect " + shape;
                glm::dvec4 clip(0.0);
                glm::dvec3 got(0.0);
                const glm::dvec3 right_place = truth::project(camera, aspect, point);
                check.call(call, [&] {
                    clip = glm::dvec4(view_projection(camera, aspect) * glm::vec4(point, 1.0f));
                    return "";
                });
                got = glm::dvec3(clip) / clip.w;
                check.expect(clip.w > 0.0 && glm::length(got - right_place) <= 5e-4,
                             call + ": " + what + " appears at " + place_text(got) + " with w = " +
                                 number_text(clip.w) + ", expected " + place_text(right_place) + " and w above 0",
                             hint_for(clip, got, right_place));
            }
    }
}

}  // namespace lightwalk
