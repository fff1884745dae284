// Rays on the device: through the hierarchy as without it, against double precision, and none between triangles.
#include <cmath>

#include "05_shadow_maps/ray_fixture.h"
#include "catch.h"

using namespace lightwalk;

namespace {

struct Found {
    double t = INFINITY;
    double margin = 0;  ///< how far from the nearest edge, in barycentric coordinates; below 0: outside
};

// The determinants of T. Möller and B. Trumbore (1997), in double precision.
Found exact_hit(const RayTriangle& triangle, const TestRay& ray) {
    const glm::dvec3 a(triangle.a), e1 = glm::dvec3(triangle.b) - a, e2 = glm::dvec3(triangle.c) - a;
    const glm::dvec3 d(ray.direction), p = glm::cross(d, e2), s = glm::dvec3(ray.origin) - a, q = glm::cross(s, e1);
    const double det = glm::dot(e1, p);
    if (det == 0) return {INFINITY, -1};
    const double v = glm::dot(s, p) / det, w = glm::dot(d, q) / det;
    return {glm::dot(e2, q) / det, std::min({v, w, 1 - v - w})};
}

// The fault of a hit; "" if none. Where the nearest triangles' edges decide it, either is.
std::string wrong_hit(std::span<const RayTriangle> triangles, const TestRay& ray, const TestHit& hit) {
    constexpr double edge = 1e-4;
    double inside = INFINITY, nearby = INFINITY;  // the nearest that is surely hit, and that may be
    for (const RayTriangle& triangle : triangles) {
        const Found found = exact_hit(triangle, ray);
        if (!(found.t > double(ray.least) && found.t < double(ray.most))) continue;
        if (found.margin > edge) inside = std::min(inside, found.t);
        if (found.margin > -edge) nearby = std::min(nearby, found.t);
    }
    const double t = hit.found ? double(hit.t) : INFINITY, slack = 1e-4 * (1 + (std::isfinite(t) ? t : 0));
    if (t > inside + slack) return "passed through a triangle";
    if (t < nearby - slack) return "hit what is not there";
    return {};
}

size_t count_differences(const std::vector<TestHit>& one, const std::vector<TestHit>& two) {
    size_t different = 0;
    for (size_t i = 0; i < one.size(); ++i)
        different += one[i].found != two[i].found || one[i].t != two[i].t || one[i].any != two[i].any;
    return different;
}

// Towards critical points: the corners of triangles, and points on their edges.
std::vector<TestRay> grazing_rays(const std::vector<RayTriangle>& triangles, glm::vec3 from, size_t count) {
    Random random;
    std::vector<TestRay> rays;
    while (rays.size() < count) {
        const RayTriangle& t = triangles[static_cast<size_t>(random.uniform(0, double(triangles.size() - 1)))];
        const auto part = static_cast<float>(random.uniform(0, 1));
        for (const glm::vec3& to : {t.a, 0.5f * (t.b + t.c), glm::mix(t.a, t.c, part)})
            rays.push_back({.origin = from, .direction = to - from});
    }
    return rays;
}

}  // namespace

TEST_CASE("rays find through the hierarchy what they find by asking every triangle") {
    Gpu& gpu = check_device();
    for (const char* model : {"models/teapot.obj", "models/cornell_box.obj"}) {
        const auto triangles = triangles_of(model);
        const Bvh bvh(triangles);
        auto rays = random_rays(bounds_of(triangles), 3000);
        for (const TestRay& ray : grazing_rays(triangles, {0.1f, 3.0f, 0.2f}, 3000)) rays.push_back(ray);
        for (int axis = 0; axis < 3;
             ++axis)  // along the axes, through corners: 0 times infinity, if one is not careful
            for (size_t i = 0; i < 500; ++i) {
                TestRay ray{.origin = triangles[i * 7 % triangles.size()].b, .direction = glm::vec3(0.0f)};
                ray.direction[axis] = i % 2 ? 1.0f : -1.0f;
                ray.origin -= 2.0f * ray.direction;
                rays.push_back(ray);
            }
        const auto hits = trace(gpu, bvh, rays), all = trace(gpu, bvh, rays, true);
        INFO(model);
        CHECK(count_differences(hits, all) == 0);
        size_t found = 0, any_differs = 0;
        for (const TestHit& hit : hits) {
            found += hit.found;
            any_differs += hit.any != hit.found;
        }
        CHECK(found > rays.size() / 4);
        CHECK(found < rays.size());
        CHECK(any_differs == 0);
    }
}

TEST_CASE("rays hit what they hit in double precision") {
    Gpu& gpu = check_device();
    const auto triangles = triangles_of("models/teapot.obj");
    const Bvh bvh(triangles);
    auto rays = random_rays(bounds_of(triangles), 3000, 2);
    for (size_t i = 0; i < rays.size(); i += 3) {
        rays[i].least = 0.2f;
        rays[i].most = 0.9f;
    }
    const auto hits = trace(gpu, bvh, rays);
    std::map<std::string, size_t> wrong;
    for (size_t i = 0; i < rays.size(); ++i) ++wrong[wrong_hit(bvh.triangles(), rays[i], hits[i])];
    CHECK(wrong.size() == 1);
    CHECK(wrong[""] == rays.size());
    // A hit is identified by its point on the ray.
    double worst = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].found) continue;
        const RayTriangle& t = bvh.triangles()[hits[i].triangle];
        const glm::vec3 on = hits[i].weights.x * t.a + hits[i].weights.y * t.b + hits[i].weights.z * t.c;
        worst = std::max(worst, double(glm::length(on - (rays[i].origin + hits[i].t * rays[i].direction))));
    }
    CHECK(worst < 1e-4);
}

TEST_CASE("no ray leaves a closed surface, not through its edges and corners either") {
    Gpu& gpu = check_device();
    const auto ball = triangles_of("models/sphere.obj");
    for (const glm::vec3 from : {glm::vec3(0), glm::vec3(0.3f, -0.2f, 0.1f), glm::vec3(0.01f, 0.4f, -0.2f)}) {
        const auto hits = trace(gpu, Bvh(ball), grazing_rays(ball, 0.5f * bounds_of(ball).extent().x * from, 60000));
        size_t leaks = 0;
        for (const TestHit& hit : hits) leaks += !hit.found + !hit.any;
        CHECK(leaks == 0);
    }
}

TEST_CASE("rays along a flat surface, within boxes without a height, and through nothing") {
    Gpu& gpu = check_device();
    const Bvh ground({triangle({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}), triangle({-1, 0, -1}, {1, 0, 1}, {-1, 0, 1}),
                      triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})});
    const std::vector<TestRay> rays{{.origin = {0.2f, 1, 0.1f}, .direction = {0, -1, 0}},
                                    {.origin = {0, 1, 0}, .direction = {0, -1, 0}},
                                    {.origin = {-3, 0, 0}, .direction = {1, 0, 0}},  // in its plane: seen from the side
                                    {.origin = {0.2f, 1e-6f, 0}, .direction = {1, -1e-6f, 0}},
                                    {.origin = {0.2f, 1, 0.1f}, .direction = {0, 1, 0}},
                                    {.origin = {0.2f, 1, 0.1f}, .direction = {0, -1, 0}, .most = 0.99f},
                                    {.origin = {0.2f, 1, 0.1f}, .least = 1.01f, .direction = {0, -1, 0}}};
    const std::vector<uint32_t> expected{1, 1, 0, 0, 0, 0, 0};
    const auto hits = trace(gpu, ground, rays), nothing = trace(gpu, Bvh(), rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        INFO("ray " << i);
        CHECK(hits[i].found == expected[i]);
        CHECK(hits[i].any == expected[i]);
        CHECK(nothing[i].found + nothing[i].any == 0);
    }
}
