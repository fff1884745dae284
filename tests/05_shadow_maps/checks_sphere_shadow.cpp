// What ./course check runs for 05.sphere_shadow.
#include "05_shadow_maps/ray_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

constexpr const char* file = "05_shadow_maps/sphere_shadow.glsl";

glm::dvec3 vector3(std::span<const double> in, size_t at) { return {in[at], in[at + 1], in[at + 2]}; }

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

void check_share(Check& check) {
    Probe probe{.include = file,
                .signature = "float hidden_share(float radius, float gap)",
                .truth = [](auto in) -> Row { return {truth::hidden_share(in[0], in[1])}; },
                .bound = {.absolute = 2e-3},
                .hint = [](auto in, auto) -> std::string {
                    if (in[1] >= 1) return "the discs do not meet";
                    if (in[0] + in[1] <= std::fabs(1 - in[0]))
                        return in[0] < 1 ? "all of the planet is in front of the sun, and hides its own area"
                                         : "nothing of the sun is seen";
                    if (in[0] > 100)
                        return "the planet's edge is nearly straight here: what does the sun's segment say?";
                    return "two segments: of the sun beyond the chord, and of the planet on the chord's other side";
                }};
    for (const double radius : {0.0, 0.1, 0.5, 0.999, 1.0, 1.001, 2.0, 16.0, 100.0, 1e3, 1e4, 1e6})
        for (const double gap : {-1e6, -1000.5, -1.0, -0.99, -0.5, 0.0, 0.5, 0.99, 1.0, 2.0, 1e6})
            if (gap >= -radius) probe.inputs.push_back({radius, gap});
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double radius = random.logarithmic(0.05, 1e5);
        probe.inputs.push_back({radius, random.uniform(std::max(-radius, -1.5), 1.5)});
    }
    for (Row& row : probe.inputs)
        for (double& number : row) number = double(float(number));
    const Table results = check.probe(probe);
    check.property(probe, results, "but a share is from 0 to 1",
                   [](auto, auto out) { return out[0] >= -1e-4 && out[0] <= 1.0001; });
}

}  // namespace

CHECK_EXERCISE("05.sphere_shadow",
               "how far does the line towards the light pass from the sphere's middle, and where?") {
    check_hard(check);
    check_power(check);
    check_share(check);
}
