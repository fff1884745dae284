// The picture on the ground and on the dome around it: in line with the ray's own place, and nowhere sheared.
#include <cmath>

#include "../common/gpu_fixture.h"
#include "common/check/check.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

const glm::dvec3 eye{-0.3, 1.55, 5.4}, camera{0.0, 1.6, 0.0};  // of the scene beat.json; of the photograph

glm::dvec3 ray(double x, double y) { return glm::normalize(glm::dvec3(0.53 * x, -0.01 - 0.29 * y, -1.0)); }

Row inputs_of(glm::dvec3 direction) {
    return {eye.x, eye.y, eye.z, direction.x, direction.y, direction.z, 0.0, camera.y, 14.0};
}

Table seen_from(const Table& inputs) {
    return run_probe(check_device(),
                     {.include = "14_environment/projected_ground.glsl",
                      .signature = "vec3 projected_direction(vec3 eye, vec3 direction, float ground_y, float camera_m, "
                                   "float radius_m)",
                      .inputs = inputs},
                     3);
}

glm::dvec3 vector_of(const Row& row) { return {row[0], row[1], row[2]}; }

}  // namespace

TEST_CASE("the photograph's ray and the picture's meet in one place, on the ground or on the dome",
          "[projected_ground]") {
    Table inputs;
    for (double x = -1; x <= 1; x += 0.05)
        for (double y = -0.2; y <= 1; y += 0.05) inputs.push_back(inputs_of(ray(x, y)));
    const Table found = seen_from(inputs);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 direction(inputs[i][3], inputs[i][4], inputs[i][5]), seen = vector_of(found[i]);
        // Where two lines meet: t along the ray by the normal of both.
        const glm::dvec3 across = glm::cross(direction, seen);
        if (glm::length(across) < 1e-3) continue;
        CHECK(std::abs(glm::dot(camera - eye, across)) < 1e-4);
        const double t = glm::dot(glm::cross(camera - eye, seen), across) / glm::dot(across, across);
        const glm::dvec3 place = eye + t * direction;
        const double edge = 14.0, dome = std::hypot(edge, camera.y);
        INFO(place.x << ", " << place.y << ", " << place.z);
        CHECK((std::abs(place.y) < 0.02 || std::abs(glm::length(place - camera) - dome) < 0.05));
        CHECK(std::hypot(place.x, place.z) < edge + 0.1);
    }
}

// A blend of the ground's direction with the ray's own reached 20, where black quay steps became a smear.
TEST_CASE("the picture is stretched at most 8 times as much one way as the other", "[projected_ground]") {
    constexpr double step = 2e-3;
    Table inputs;
    for (double x = -0.95; x <= 0.96; x += 0.1)
        for (double y = 0.0; y <= 0.5; y += 0.01)
            for (const glm::dvec2 aside : {glm::dvec2(0), glm::dvec2(step, 0), glm::dvec2(0, step)})
                inputs.push_back(inputs_of(ray(x + aside.x / 0.53, y + aside.y / 0.29)));
    const Table found = seen_from(inputs);
    double worst = 0;
    for (size_t i = 0; i < found.size(); i += 3) {
        const glm::dvec3 a = (vector_of(found[i + 1]) - vector_of(found[i])) / step;
        const glm::dvec3 b = (vector_of(found[i + 2]) - vector_of(found[i])) / step;
        const double half = 0.5 * (glm::dot(a, a) + glm::dot(b, b)), between = glm::dot(a, b);
        const double root = std::sqrt(std::max(half * half - glm::dot(a, a) * glm::dot(b, b) + between * between, 0.0));
        worst = std::max(worst, std::sqrt((half + root) / std::max(half - root, 1e-12)));
    }
    INFO("stretched " << worst << " times");
    CHECK(worst < 8);
}
