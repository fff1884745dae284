// The share of a lamp that is seen, by rays: against closed forms, and how fast it comes near them.
#include <cmath>
#include <set>

#include "05_shadow_maps/ray_fixture.h"
#include "05_shadow_maps/ray_truth.h"
#include "05_shadow_maps/rays.h"
#include "catch.h"

using namespace lightwalk;

namespace {

struct LampQuery {
    glm::vec3 origin;
    uint32_t seed = 0;
    glm::vec3 to_middle;
    float radius = 0, most = 1;
};

constexpr float on_and_on = 1e13f;

std::vector<float> visibilities(Gpu& gpu, const Bvh& bvh, const std::vector<LampQuery>& queries, int samples,
                                uint32_t first_sample = 0) {
    static const Pipeline pipeline = compute({.shader = "lamps", .macros = {{"RAYS_SOLID", "1"}}, .source = R"(
#include "05_shadow_maps/rays.glsl"
layout(local_size_x = 64) in;
struct Query { vec3 origin; uint seed; vec3 to_middle; float radius, most; };
layout(scalar) readonly buffer QueryBuffer { Query queries[]; };
layout(scalar) writeonly buffer ResultBuffer { float results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length()) return;
    Query q = queries[i];
    results[i] = lamp_visibility(Lamp(q.to_middle, q.radius, q.most), q.origin, q.seed);
}
)"});
    const Buffer nodes = gpu.upload("nodes", std::as_bytes(bvh.nodes()));
    const Buffer triangles = gpu.upload("triangles", std::as_bytes(bvh.triangles()));
    const Buffer in = gpu.upload("queries", queries);
    const Buffer out(gpu.device, {.name = "results", .bytes = std::max<size_t>(16, queries.size() * 4)});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("lamps", {.writes = {out}}, [&](Compute& pass) {
        pass.use(pipeline).set("rays_nodes", nodes).set("rays_triangles", triangles);
        pass.set("queries", in).set("results", out).set("rays", samples);
        pass.set("rays_state", RayState{.first_sample = first_sample});
        pass.dispatch_threads(glm::uvec3(queries.size(), 1, 1));
    });
    frame.end();
    const auto bytes = gpu.read_back(out);
    std::vector<float> result(queries.size());
    std::memcpy(result.data(), bytes.data(), 4 * result.size());
    return result;
}

constexpr double edge_m = 2;  // how high the edge is above the ground
// Covers x < 0 there.
const Bvh& half_plane() {
    static const Bvh bvh({triangle({0, edge_m, -1000}, {0, edge_m, 1000}, {-1000, edge_m, 1000}),
                          triangle({0, edge_m, -1000}, {-1000, edge_m, 1000}, {-1000, edge_m, -1000})});
    return bvh;
}

struct Errors {
    double rms = 0, largest = 0, mean = 0;
};

// Over the penumbra of the half plane, from dark to light, with several seeds.
Errors penumbra_errors(int samples, bool sun) {
    constexpr double lamp_m = 5, radius = 0.4;
    std::vector<LampQuery> queries;
    std::vector<double> expected;
    for (int i = -60; i <= 60; ++i)
        for (uint32_t seed = 0; seed < 8; ++seed) {
            const double x = i * (sun ? 0.015 : 0.005);
            queries.push_back({.origin = {x, 0, 0}, .seed = seed * 977 + static_cast<uint32_t>(i + 100)});
            queries.back().radius = static_cast<float>(radius);
            const double at = double(queries.back().origin.x);
            if (sun) {
                queries.back().to_middle = {0, 1, 0};
                queries.back().most = on_and_on;
                expected.push_back(truth::disc_beyond(-at / (edge_m * radius)));
            } else {
                queries.back().to_middle = {-at, lamp_m, 0};
                const double away = std::hypot(at, lamp_m);
                expected.push_back(
                    truth::disc_beyond(at * (edge_m - lamp_m) * away / (radius * (lamp_m * edge_m + at * at))));
            }
        }
    const auto got = visibilities(check_device(), half_plane(), queries, samples);
    Errors errors;
    for (size_t i = 0; i < got.size(); ++i) {
        const double error = double(got[i]) - expected[i];
        errors.rms += error * error;
        errors.mean += error;
        errors.largest = std::max(errors.largest, std::fabs(error));
    }
    errors.rms = std::sqrt(errors.rms / double(got.size()));
    errors.mean /= double(got.size());
    return errors;
}

}  // namespace

TEST_CASE("every 2^k points of the sequence stand one in each of 2^k equal boxes, whatever the seed") {
    for (const uint32_t seed : {0u, 1u, 12345u}) {
        Probe probe{.include = "05_shadow_maps/sampling.glsl", .signature = "vec2 sobol_point(uint index, uint seed)"};
        for (uint32_t i = 0; i < 256; ++i) probe.inputs.push_back({double(i), double(seed)});
        const Table points = run_probe(check_device(), probe, 2);
        for (const uint32_t first : {0u, 64u, 192u})
            for (uint32_t log_wide = 0; log_wide <= 6; ++log_wide) {
                std::set<std::pair<int, int>> boxes;
                for (uint32_t i = first; i < first + 64; ++i)
                    boxes.emplace(int(points[i][0] * (1 << log_wide)), int(points[i][1] * (1 << (6 - log_wide))));
                CHECK(boxes.size() == 64);
            }
    }
}

TEST_CASE("the penumbra of a straight edge is the share of a disc beyond a line") {
    for (const bool sun : {true, false}) {
        double before = 1;
        for (const int samples : {4, 16, 64, 256, 1024}) {
            const Errors errors = penumbra_errors(samples, sun);
            WARN((sun ? "sun, " : "lamp, ") << samples << " rays: rms " << errors.rms << ", largest " << errors.largest
                                            << ", mean " << errors.mean);
            // A quarter of the error for four times the rays, were it smooth; an edge costs a part of that.
            CHECK(errors.rms < 0.45 * before);
            CHECK(errors.rms < 0.7 * std::pow(samples, -0.75));
            CHECK(errors.largest < 2.5 * std::pow(samples, -0.75));
            CHECK(std::fabs(errors.mean) < 0.2 * errors.rms + 1e-5);
            before = errors.rms;
        }
    }
}

TEST_CASE("frames go on in the sequence where the one before ended") {
    std::vector<LampQuery> queries;
    for (int i = -20; i <= 20; ++i)
        queries.push_back({.origin = {0.04 * i, 0, 0},
                           .seed = static_cast<uint32_t>(i + 20),
                           .to_middle = {0, 1, 0},
                           .radius = 0.4f,
                           .most = on_and_on});
    const auto whole = visibilities(check_device(), half_plane(), queries, 64);
    std::vector<float> sum(queries.size());
    for (uint32_t frame = 0; frame < 4; ++frame) {
        const auto part = visibilities(check_device(), half_plane(), queries, 16, 16 * frame);
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += 0.25f * part[i];
    }
    for (size_t i = 0; i < sum.size(); ++i) CHECK(double(sum[i]) == Approx(double(whole[i])).margin(1e-6));
}

TEST_CASE("a lamp without a size takes one ray, one in the way of nothing shines, one at the point itself, too") {
    const std::vector<LampQuery> queries{{.origin = {-1, 0, 0}, .to_middle = {0, 1, 0}, .most = on_and_on},
                                         {.origin = {1, 0, 0}, .to_middle = {0, 1, 0}, .most = on_and_on},
                                         {.origin = {-1, 0, 0}, .to_middle = {0, 1.9f, 0}},  // below the edge
                                         {.origin = {-1, 0, 0}, .to_middle = {0, 2.1f, 0}},
                                         {.origin = {-1, 0, 0}, .to_middle = {0, 0, 0}, .radius = 0.1f},
                                         {.origin = {-1, 3, 0}, .to_middle = {0, -1, 0}, .most = on_and_on}};
    const std::vector<float> expected{0, 1, 1, 0, 1, 0};
    CHECK(visibilities(check_device(), half_plane(), queries, 7) == expected);
}

TEST_CASE("more rays than a driver's loops may turn give no number, rather than a wrong one") {
    // In the dark: a ray that is ended on its way has met nothing, and would count as light.
    const LampQuery query{.origin = {-50, 0, 0}, .to_middle = {0, 1, 0}, .radius = 0.4f, .most = on_and_on};
    const auto seen = [&](int samples) { return visibilities(check_device(), half_plane(), {query}, samples)[0]; };
    int most = 64, too_many = 1 << 17;
    CHECK(seen(most) == 0);
    if (seen(too_many) == 0) return;  // this driver's loops have no end
    while (too_many - most > 1) (seen((most + too_many) / 2) == 0 ? most : too_many) = (most + too_many) / 2;
    for (int samples = most - 3; samples <= most + 8; ++samples) {
        INFO(samples);
        const float found = seen(samples);
        CHECK((samples <= most ? found == 0 : std::isnan(found)));
    }
    struct Owner : Module {
    } owner;
    Rays rays{owner, "rays"};
    rays.truth_samples.value = 64;
    CHECK(rays.why_not_finite().find("take 16, and 4 times as many --samples") != std::string::npos);
}
