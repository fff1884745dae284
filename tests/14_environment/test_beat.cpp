// The sphere that music moves: its triangles, its waves and their normals, and its pictures as functions of time.
#include <cmath>
#include <map>

#include "../common/gpu_fixture.h"
#include "14_environment/surroundings.h"
#include "common/check/check.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

// As 14_environment/beat_waves.glsl has it.
double waves(glm::dvec3 n, double frequency, double exponent) {
    const double a = 0.5257311121191336, b = 0.8506508083520399;
    const glm::dvec3 axes[6] = {{0, a, b}, {0, -a, b}, {a, b, 0}, {-a, b, 0}, {b, 0, a}, {b, 0, -a}};
    double sum = 0;
    for (const glm::dvec3& axis : axes) sum += std::cos(frequency * glm::dot(n, axis));
    return std::pow(std::max(sum / 12 + 0.5, 1e-6), exponent);
}

Row row_of(glm::dvec3 n, std::initializer_list<double> more) {
    Row row{n.x, n.y, n.z};
    row.insert(row.end(), more);
    return row;
}

glm::dvec3 somewhere(Random& random) {
    const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * M_PI), r = std::sqrt(1 - z * z);
    return glm::dvec3(glm::vec3(r * std::cos(turn), r * std::sin(turn), z));
}

// The normal of (1 + h(n)) n by differences, for any h.
template <class Height>
glm::dvec3 normal_by_differences(glm::dvec3 n, const Height& h) {
    const glm::dvec3 right =
        glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
    const glm::dvec3 up = glm::cross(n, right);
    const double step = 1e-5;
    const auto place = [&](glm::dvec3 at) { return (1 + h(glm::normalize(at))) * glm::normalize(at); };
    return glm::normalize(
        glm::cross(place(n + step * right) - place(n - step * right), place(n + step * up) - place(n - step * up)));
}

}  // namespace

TEST_CASE("the sphere has 200,000 triangles that face outwards, and each edge has two of them") {
    for (const uint32_t parts : {1u, 2u, 7u, 100u}) {
        const Geodesic sphere = geodesic_sphere(parts);
        CHECK(sphere.indices.size() == 3 * 20 * parts * parts);
        CHECK(sphere.directions.size() == 10 * parts * parts + 2);
        std::map<std::pair<uint32_t, uint32_t>, int> edges;
        size_t inwards = 0, uneven = 0;
        double area = 0;
        for (size_t i = 0; i < sphere.indices.size(); i += 3) {
            const uint32_t* t = &sphere.indices[i];
            for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
            const glm::dvec3 a = sphere.directions[t[0]], b = sphere.directions[t[1]], c = sphere.directions[t[2]];
            const glm::dvec3 across = glm::cross(b - a, c - a);
            inwards += glm::dot(across, a) <= 0;
            area += glm::length(across) / 2;
        }
        CHECK(inwards == 0);
        for (const auto& [edge, count] : edges) uneven += count != 1 || edges.count({edge.second, edge.first}) != 1;
        CHECK(uneven == 0);
        if (parts == 100) CHECK(area == Approx(4 * M_PI).epsilon(2e-4));
        for (const glm::vec3& direction : sphere.directions) REQUIRE(std::abs(glm::length(direction) - 1) < 2e-7f);
    }
}

TEST_CASE("waves and their gradients are those of double precision") {
    Random random;
    Table inputs;
    for (int i = 0; i < 300; ++i)
        inputs.push_back(row_of(somewhere(random), {random.uniform(1, 60), double(2 + i % 5)}));
    const Table found = run_probe(check_device(),
                                  {.include = "14_environment/beat_waves.glsl",
                                   .signature = "vec4 waves(vec3 n, float frequency, float exponent)",
                                   .inputs = inputs},
                                  4);
    double worst = 0, worst_slope = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 n(inputs[i][0], inputs[i][1], inputs[i][2]);
        const double frequency = inputs[i][3], exponent = inputs[i][4], step = 1e-6;
        worst = std::max(worst, std::abs(found[i][3] - waves(n, frequency, exponent)));
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 aside(0.0);
            aside[axis] = step;
            const double slope =
                (waves(n + aside, frequency, exponent) - waves(n - aside, frequency, exponent)) / (2 * step);
            worst_slope = std::max(worst_slope, std::abs(found[i][size_t(axis)] - slope) / frequency);
        }
    }
    CHECK(worst < 3e-5);
    CHECK(worst_slope < 3e-5);
}

TEST_CASE("the normal is that of the displaced surface, to 0.01 degrees, and the sphere's where nothing is displaced",
          "[14.sphere_normal]") {
    Random random;
    Table inputs;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 n = somewhere(random);
        const double height = i % 4 ? 0.4 : 0.0, frequency = 14;
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 aside(0.0);
            aside[axis] = 1e-6;
            gradient[axis] = height * (waves(n + aside, frequency, 6) - waves(n - aside, frequency, 6)) / 2e-6;
        }
        inputs.push_back(row_of(n, {gradient.x, gradient.y, gradient.z, height * waves(n, frequency, 6)}));
    }
    const Table found = run_probe(check_device(),
                                  {.include = "14_environment/beat_waves.glsl",
                                   .signature = "vec3 normal_above(vec3 n, vec4 height)",
                                   .inputs = inputs},
                                  3);
    double worst = 0, steepest = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 n(inputs[i][0], inputs[i][1], inputs[i][2]), got(found[i][0], found[i][1], found[i][2]);
        const glm::dvec3 right =
            normal_by_differences(n, [&](glm::dvec3 at) { return (i % 4 ? 0.4 : 0.0) * waves(at, 14, 6); });
        worst = std::max(worst, glm::degrees(glm::length(got - right)));
        steepest = std::max(steepest, glm::degrees(std::acos(std::min(glm::dot(n, right), 1.0))));
    }
    CHECK(steepest > 50);  // error of the undisplaced normal
    CHECK(worst < 0.01);
}
