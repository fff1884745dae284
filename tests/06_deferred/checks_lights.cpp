// Checks of light culling: a workgroup of pixels, and the volume of a light.
#include <fmt/core.h>

#include <algorithm>
#include <cstring>

#include "03_attenuation/lights.h"
#include "06_deferred/deferred_lights.h"
#include "06_deferred/exercises.h"
#include "06_deferred/truth.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"

using namespace lightwalk;

namespace {

// Four tiles of 256 invocations. Each has a cell of its own; of every 16 invocations one has no surface. The
// exercise's result is compared with a plain loop's, and its queries per light are counted. Only this check knows
// which lights reach a cell, so an answer must query. The decision is made before the answer, in names that no answer
// may have.
constexpr const char* harness = R"(
layout(local_size_x = 16, local_size_y = 16) in;
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
layout(scalar) buffer AskedBuffer { uint check_asked[]; };
layout(scalar) uniform DrawnBlock { uint check_drawn; };
bool check_reaches(LightData light, Cell cell) {
    uint word = floatBitsToUint(light.position.x) * 2654435761u + check_drawn;
    return light_reaches_cell(light, cell) && ((word ^ word >> 15) & 3u) != 0u;
}
bool check_counted(LightData light, Cell cell) {
    atomicAdd(check_asked[gl_WorkGroupID.x], 1u);
    return check_reaches(light, cell);
}
Lit check_plainly(Cell cell, Surface surface, vec3 position) {
    Lit expected = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint i = 0u; i < lights_data.length(); ++i)
        if (check_reaches(lights_data[i], cell)) add_light(expected, i, surface, surface.normal, position);
    return expected;
}
uint check_next = 0u;
bool check_ordered = true;
void check_add(inout Lit sum, uint index, Surface surface, vec3 facing, vec3 position) {
    if (index < check_next) check_ordered = false;
    check_next = index + 1u;
    add_light(sum, index, surface, facing, position);
}
#define light_reaches_cell check_counted
#define add_light check_add
#include "06_deferred/accumulate_lights.glsl"
#undef add_light
struct Answer { float got, expected; uint got_lights, expected_lights, barriers, ordered; };
layout(scalar) writeonly buffer AnswerBuffer { Answer answers[]; };
void main() {
    float x = 4.0 * float(gl_WorkGroupID.x);
    Cell cell;
    cell.lower = vec3(x, -1.0, 8.0);
    cell.upper = vec3(x + 4.0, 1.0, 10.0);
    cell.slopes_x = vec2(-100.0, 100.0);
    cell.slopes_y = vec2(-100.0, 100.0);
    cell.margin = 1e-3;
    vec3 position = vec3(x + 0.25 * float(gl_LocalInvocationID.x), 0.0, 8.0 + 0.125 * float(gl_LocalInvocationID.y));
    Surface surface = Surface(vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), 20.0, vec3(0.0, 1.0, 0.0));
    bool has_surface = gl_LocalInvocationIndex % 16u != 5u;
    Lit got = accumulate_lights(surface, surface.normal, position, cell, has_surface);
    uint barriers = check_barriers_passed;
    Lit expected = check_plainly(cell, surface, position);
    if (!has_surface) got = expected;
    answers[gl_WorkGroupID.x * 256u + gl_LocalInvocationIndex] =
        Answer(got.diffuse.r + got.specular.r, expected.diffuse.r + expected.specular.r, got.lights, expected.lights,
               barriers, uint(check_ordered || !has_surface));
}
)";

struct Answer {
    float got, expected;
    uint32_t got_lights, expected_lights, barriers, ordered;
};

struct Answers {
    std::vector<Answer> all;
    uint32_t asked;  ///< by the tile that asked most
};

Answers answers(uint32_t lights) {
    Gpu& gpu = check_device();
    Random random(lights + 1);
    const auto drawn = static_cast<uint32_t>(random.uniform(0, 1e9));
    std::vector<LightData> data;
    for (uint32_t i = 0; i < lights; ++i) {
        Light light{.kind = Light::Kind::point, .range_m = static_cast<float>(random.uniform(0.5, 1.5))};
        light.position = {random.uniform(-2, 18), random.uniform(0.1, 1), random.uniform(7, 11)};
        data.push_back(pack(light));
    }
    struct Owner : Module {
    } owner;
    const Lights module(owner, "lights");
    const Pipeline pipeline = compute({.shader = "check of accumulate_lights",
                                       .macros = {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}},
                                       .source = traced_barriers() + harness});
    const Buffer buffer = gpu.upload("lights", data);
    const Buffer results(gpu.device, {.name = "answers", .bytes = 1024 * sizeof(Answer)});
    const Buffer counts = gpu.upload("asked", std::vector<uint32_t>(4, 0));
    const GridView axes{.eye = {}, .right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, 1}};
    {
        Frame frame(gpu);
        frame.begin({1, 1}, 0.0f);
        frame.compute(
            "accumulate_lights", {.reads = {counts}, .writes = {results, counts}, .with = {module}},
            [&](Compute& pass) {
                pass.use(pipeline).set("answers", results).set("lights_data", buffer).set("lights_grid", axes);
                pass.set("check_asked", counts).set("check_drawn", drawn).dispatch({4, 1, 1});
            });
        frame.end();
    }
    const auto bytes = gpu.read_back(results), asked = gpu.read_back(counts);
    std::vector<Answer> all(1024);
    std::memcpy(all.data(), bytes.data(), bytes.size());
    std::vector<uint32_t> times(4);
    std::memcpy(times.data(), asked.data(), asked.size());
    return {all, *std::ranges::max_element(times)};
}

}  // namespace

CHECK_EXERCISE("06.accumulate_lights",
               "clear the bits; barrier; ask about every 256th light; barrier; add what the bits say; barrier") {
    for (const uint32_t lights : {1u, 40u, 300u, 1100u, 2600u}) {
        const auto [all, asked] = answers(lights);
        const auto first = [&all = all](auto wrong) {  // of the invocations; the last one where none is
            size_t i = 0;
            while (i + 1 < all.size() && !wrong(all[i])) ++i;
            return i;
        };
        const auto who = [&](size_t i) {
            return fmt::format("with {} lights, invocation {} of a tile's 256", lights, i % 256);
        };
        const auto miscounts = [](const Answer& a) { return a.got_lights != a.expected_lights; };
        const auto missums = [](const Answer& a) {
            return !(std::fabs(a.got - a.expected) <= 1e-4f * (1.0f + std::fabs(a.expected)));
        };
        const size_t counted = first(miscounts), summed = first(missums);
        check.expect(
            !miscounts(all[counted]),
            fmt::format("{} added {} lights where {} reach the tile", who(counted), all[counted].got_lights,
                        all[counted].expected_lights),
            all[counted].got_lights == lights ? "it adds lights that do not reach the cell"
            : lights > 1024
                ? "there are more lights than bits: are all of them taken, 1,024 at a time, and does "
                  "nobody clear bits that others still read?"
                : "somebody read before all had written: a barrier() is missing (memoryBarrierShared() waits for "
                  "nobody), or some invocations never came to it");
        check.expect(!missums(all[summed]), fmt::format("{} got {} where a plain loop gets {}", who(summed),
                                                        all[summed].got, all[summed].expected));
        const size_t turned = first([](const Answer& a) { return !a.ordered; });
        check.expect(all[turned].ordered, fmt::format("{} added a light before one with a smaller number", who(turned)),
                     "the sum is over the lights in increasing order: begin with a word's lowest bit");
        check.expect(
            asked <= lights,
            fmt::format("with {} lights, a tile asked {} times whether a light reaches it: once for each is enough",
                        lights, asked),
            "each invocation asks about its share of the lights alone");
        for (size_t tile = 0; tile < 4; ++tile) {
            std::vector<uint32_t> passed;
            for (size_t i = 0; i < 256; ++i) passed.push_back(all[256 * tile + i].barriers);
            const std::string wrong = barriers_wrong(passed);
            check.expect(wrong.empty(), fmt::format("with {} lights, of a tile's 256 {}", lights, wrong), barrier_hint);
        }
        if (check.failed) return;  // too many queries take seconds with more lights
    }
}

namespace {

std::string words(const Light& light, double radius_m) {
    const auto vector = [](const glm::vec3& v) { return fmt::format("({:.3g}, {:.3g}, {:.3g})", v.x, v.y, v.z); };
    std::string text =
        fmt::format("light_volume_bounds of a {} light at {} that reaches {:.3g} m",
                    light.kind == Light::Kind::spot ? "spot" : "point", vector(light.position), radius_m);
    if (light.kind == Light::Kind::spot)
        text += fmt::format(", towards {}, half angle {:.4g} degrees", vector(light.direction),
                            glm::degrees(light.outer_rad));
    return text;
}

// How far out a point of a unit shape's own space is: at most 1 inside.
double outness(LightVolume::Shape shape, glm::dvec3 p) {
    if (shape == LightVolume::Shape::sphere) return glm::length(p);
    return p.z > 0 ? std::max(p.z, glm::length(glm::dvec2(p)) / p.z) : 2.0;
}

void expect_bounds(Check& check, const Light& light, float radius_m, Random& random) {
    const std::string call = words(light, double(radius_m));
    check.call(call, [&]() -> std::string {
        const LightVolume volume = light_volume_bounds(light, radius_m);
        const glm::dmat4 matrix(volume.to_world);
        for (int i = 0; i < 16; ++i)
            if (!std::isfinite(matrix[i / 4][i % 4])) return call + " gave a matrix that is not finite";
        if (radius_m == 0) return "";
        const double scale = std::fabs(glm::determinant(glm::dmat3(matrix)));
        const bool sphere = volume.shape == LightVolume::Shape::sphere;
        const double given = scale * 3.141592653589793 * (sphere ? 4.0 / 3.0 : 1.0 / 3.0);
        const double least = truth::least_volume(light, double(radius_m));
        const glm::dmat4 inverse = scale > 1e-9 ? glm::inverse(matrix) : glm::dmat4(1.0);
        for (int i = 0; i < 40 && scale > 1e-9; ++i) {
            glm::dvec3 way(random.direction());
            if (light.kind == Light::Kind::spot && light.outer_rad < 3.1f) {  // a direction in its cone
                const glm::dvec3 axis(light.direction), side = glm::normalize(glm::cross(axis, way));
                const double angle = double(light.outer_rad) * random.uniform(0, 0.999);
                way = std::cos(angle) * axis + std::sin(angle) * side;
            }
            const glm::dvec3 lit = glm::dvec3(light.position) + double(radius_m) * random.uniform(0.01, 1) * way;
            if (outness(volume.shape, glm::dvec3(inverse * glm::dvec4(lit, 1))) > 1.002)
                return fmt::format("{} gave a {} that does not hold ({:.4g}, {:.4g}, {:.4g}), which is lit", call,
                                   sphere ? "ball" : "cone", lit.x, lit.y, lit.z);
        }
        if (given > 1.02 * least + 1e-9)
            return fmt::format("{} gave a {} of {:.4g} m³; {:.4g} m³ are enough", call, sphere ? "ball" : "cone", given,
                               least);
        return "";
    });
}

}  // namespace

CHECK_EXERCISE("06.light_volume_bounds",
               "at the distance r the cone is r tan(outer) wide; it is the smaller one where tan(outer) is below 2") {
    Random random;
    Light point{.kind = Light::Kind::point}, spot{.kind = Light::Kind::spot};
    expect_bounds(check, point, 2.0f, random);
    expect_bounds(check, point, 0.0f, random);
    point.position = {3, -1, 7};
    expect_bounds(check, point, 0.25f, random);
    for (const glm::vec3 direction :
         {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
        for (const float degrees : {0.0f, 1.0f, 20.0f, 60.0f, 65.0f, 89.0f, 90.0f, 91.0f, 120.0f, 180.0f}) {
            spot.direction = direction;
            spot.outer_rad = glm::radians(degrees);
            expect_bounds(check, spot, 5.0f, random);
            expect_bounds(check, spot, 0.0f, random);
        }
    for (int i = 0; i < 500; ++i) {
        spot.position = glm::vec3(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8));
        spot.direction = random.direction();
        spot.outer_rad = static_cast<float>(random.uniform(0.02, 3.1));
        expect_bounds(check, spot, static_cast<float>(random.logarithmic(0.1, 30)), random);
    }
}
