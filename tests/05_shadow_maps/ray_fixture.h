// Shared by the tests of rays: triangles, and rays through them on the device.
#pragma once
#include <chrono>
#include <limits>

#include "01_obj/obj.h"
#include "05_shadow_maps/bvh.h"
#include "common/check/check.h"
#include "common/scene/scene.h"

namespace lightwalk {

struct TestRay {
    glm::vec3 origin;
    float least = 0;
    glm::vec3 direction;
    float most = std::numeric_limits<float>::max();
};

struct TestHit {
    float t;  ///< `most` where nothing is hit
    uint32_t triangle;
    glm::vec3 weights;
    uint32_t found, any;  ///< 0 or 1: results of closest_hit() and any_hit()
};

inline RayTriangle triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) { return {a, b, c, NO_CUTOUT}; }

inline std::vector<RayTriangle> triangles_of(const char* model) {
    std::vector<RayTriangle> triangles;
    const Model loaded = load_model(find_asset(model), Loader::parallel);
    for (const Mesh& mesh : loaded.meshes)
        for (size_t i = 0; i < mesh.indices.size(); i += 3)
            triangles.push_back(triangle(mesh.vertices[mesh.indices[i]].position,
                                         mesh.vertices[mesh.indices[i + 1]].position,
                                         mesh.vertices[mesh.indices[i + 2]].position));
    return triangles;
}

inline Bounds bounds_of(std::span<const RayTriangle> triangles) {
    Bounds bounds;
    for (const RayTriangle& t : triangles) {
        bounds.add(t.a);
        bounds.add(t.b);
        bounds.add(t.c);
    }
    return bounds;
}

/// From a sphere around the bounds towards points in them, and from points in them anywhere.
inline std::vector<TestRay> random_rays(const Bounds& bounds, size_t count, unsigned seed = 1) {
    Random random(seed);
    const float radius = 0.5f * glm::length(bounds.extent());
    const auto inside = [&] {
        glm::vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = static_cast<float>(random.uniform(bounds.lower[axis], bounds.upper[axis]));
        return p;
    };
    std::vector<TestRay> rays;
    while (rays.size() < count) {
        const glm::vec3 from = bounds.center() + 1.5f * radius * random.direction();
        rays.push_back({.origin = from, .direction = inside() - from});
        rays.push_back({.origin = inside(), .direction = random.direction()});
    }
    return rays;
}

/// Traces rays on the device through a hierarchy, or (`every`) asks every triangle with the same arithmetic.
inline std::vector<TestHit> trace(Gpu& gpu, const Bvh& bvh, const std::vector<TestRay>& rays, bool every = false,
                                  double* ms = nullptr) {
    static const std::string head = R"(
#include "05_shadow_maps/bvh.glsl"
layout(local_size_x = 64) in;
struct Result { float t; uint triangle; vec3 weights; uint found, any; };
layout(scalar) readonly buffer RaysBuffer { Ray test_rays[]; };
layout(scalar) writeonly buffer ResultsBuffer { Result results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= test_rays.length()) return;
    Ray ray = test_rays[i];
    RayHit hit;
    bool found;
)";
    static const std::string tail = R"(
    results[i] = Result(hit.t, hit.triangle, hit.weights, uint(found), uint(any));
}
)";
    static const Pipeline through = compute({.shader = "trace", .macros = {{"RAYS_SOLID", "1"}}, .source = head + R"(
    found = closest_hit(ray, hit);
    bool any = any_hit(ray);)" + tail});
    static const Pipeline all = compute({.shader = "trace all", .macros = {{"RAYS_SOLID", "1"}}, .source = head + R"(
    hit = RayHit(ray.most, 0u, vec3(0.0));
    Shear shear = shear_of(ray.direction);
    for (uint k = 0u; k < rays_triangles.length(); ++k)
        if (hit_triangle(rays_triangles[k], ray, shear, hit)) {
            hit.triangle = k;
            found = true;
        }
    bool any = found;)" + tail});
    const Buffer nodes = gpu.upload("nodes", std::as_bytes(bvh.nodes()));
    const Buffer triangles = gpu.upload("triangles", std::as_bytes(bvh.triangles()));
    const Buffer in = gpu.upload("rays", rays);
    const Buffer out(gpu.device, {.name = "results", .bytes = rays.size() * sizeof(TestHit)});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("trace", {.writes = {out}}, [&](Compute& pass) {
        pass.use(every ? all : through).set("rays_nodes", nodes).set("rays_triangles", triangles);
        pass.set("test_rays", in).set("results", out).set("rays_state", RayState{});
        pass.dispatch_threads(glm::uvec3(rays.size(), 1, 1));
    });
    const auto start = std::chrono::steady_clock::now();
    frame.end();  // waits
    if (ms) *ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const auto bytes = gpu.read_back(out);
    std::vector<TestHit> hits(rays.size());
    std::memcpy(hits.data(), bytes.data(), hits.size() * sizeof(TestHit));
    return hits;
}

}  // namespace lightwalk
