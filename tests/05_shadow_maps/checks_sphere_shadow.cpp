// Checks of 05.sphere_shadow.
#include "05_shadow_maps/ray_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

constexpr const char* file = "05_shadow_maps/sphere_shadow.glsl";

void add(Table& inputs, glm::vec3 to_center, float radius, glm::vec3 to_light, const Row& more = {}) {
    Row row;
    append(row, to_center);
    row.push_back(double(radius));
    append(row, to_light);
    row.insert(row.end(), more.begin(), more.end());
    inputs.push_back(row);
}

// Deep in the shadow, beside it, behind the sphere and in front of it; none so near an edge that rounding decides.
void add_places(Table& inputs, const Row& more) {
    Random random;
    while (inputs.size() < 1000) {
        const glm::vec3 center = float(random.uniform(0, 5)) * random.direction();
        const auto radius = float(random.uniform(0.1, 2));
        const glm::vec3 light = random.direction();
        const double distance = truth::line_distance(center, light);
        const bool near_side = std::fabs(glm::dot(center, light)) < 1e-3f;
        if (std::fabs(distance - double(radius)) > 1e-4 && !near_side) add(inputs, center, radius, light, more);
    }
}

std::string where(std::span<const double> in) {
    const glm::dvec3 center = vector3(in, 0), light = vector3(in, 4);
    if (glm::dot(center, light) < 0) return "the sphere is behind the point, seen from the light: it shadows nothing";
    return truth::line_distance(center, light) < in[3] ? "the line towards the light goes through the sphere"
                                                       : "the line towards the light passes beside the sphere";
}

void check_hard(Check& check) {
    Probe probe{.include = file,
                .signature = "float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light)",
                .truth = [](auto in) -> Row {
                    const double distance = truth::line_distance(vector3(in, 0), vector3(in, 4));
                    return {distance >= 0 && distance < in[3] ? 0.0 : 1.0};
                },
                .hint = [](auto in, auto) { return where(in); }};
    add(probe.inputs, {0, 3, 0}, 1, {0, 1, 0});
    add(probe.inputs, {0, -3, 0}, 1, {0, 1, 0});
    add(probe.inputs, {2, 3, 0}, 1, {0, 1, 0});
    add(probe.inputs, {0.5, 30, 0}, 1, {0, 1, 0});
    add_places(probe.inputs, {});
    check.probe(probe);
}

void check_power(Check& check) {
    Probe probe{
        .include = file,
        .signature = "float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power)",
        .truth = [](auto in) -> Row {
            const double distance = truth::line_distance(vector3(in, 0), vector3(in, 4));
            if (distance < 0 || distance >= in[3]) return {1};
            return {1 - std::pow(std::min((in[3] - distance) / in[7], 1.0), in[8])};
        },
        .bound = {.absolute = 2e-3},  // near the edge a root is steep
        .hint = [](auto in, auto got) -> std::string {
            const glm::dvec3 center = vector3(in, 0), light = vector3(in, 4);
            const double distance = truth::line_distance(center, light);
            if (distance >= 0 && distance < in[3] && got[0] != 0 && in[3] - distance >= in[7])
                return "deeper than the width of the edge it is dark";
            return where(in);
        }};
    add(probe.inputs, {0, 3, 0}, 1, {0, 1, 0}, {0.5, 1});
    add(probe.inputs, {0.75, 3, 0}, 1, {0, 1, 0}, {0.5, 1});
    add(probe.inputs, {0.75, 3, 0}, 1, {0, 1, 0}, {0.5, 2});
    add(probe.inputs, {0.75, -3, 0}, 1, {0, 1, 0}, {0.5, 2});
    add(probe.inputs, {1.25, 3, 0}, 1, {0, 1, 0}, {0.5, 2});
    add(probe.inputs, {1, 3, 0}, 1, {0, 1, 0}, {0.5, 0.5});
    add_places(probe.inputs, {0.3, 0.7});
    check.probe(probe);
}

}  // namespace

CHECK_EXERCISE("05.sphere_shadow",
               "at what distance does the line towards the light pass the sphere's centre, and on which side?") {
    check_hard(check);
    check_power(check);
}
