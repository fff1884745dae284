// The hierarchy itself: every triangle once, boxes that contain their children, a bounded depth, for any input.
#include <cmath>

#include "05_shadow_maps/ray_fixture.h"
#include "catch.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

bool holds(const BvhNode& node, glm::vec3 p) {
    return glm::all(glm::lessThanEqual(node.lower, p)) && glm::all(glm::lessThanEqual(p, node.upper));
}

// Returns the fault; empty if none.
std::string wrong_in(const Bvh& bvh, size_t triangles) {
    std::vector<int> seen(bvh.triangles().size());
    struct Visit {
        uint32_t node, depth;
    };
    std::vector<Visit> visits{{0, 0}};
    const std::span<const BvhNode> nodes = bvh.nodes();
    uint32_t deepest = 0;
    size_t reached = 0;
    while (!visits.empty()) {
        const auto [at, depth] = visits.back();
        visits.pop_back();
        ++reached;
        deepest = std::max(deepest, depth);
        const BvhNode& node = nodes[at];
        if (node.count == 0)
            for (const uint32_t child : {node.first, node.first + 1}) {
                if (child <= at) return "a child before its parent";
                if (child >= nodes.size()) return "a child that is not there";
                const BvhNode& below = nodes[child];
                if (!holds(node, below.lower) || !holds(node, below.upper)) return "a child's box sticks out";
                visits.push_back({child, depth + 1});
            }
        if (node.count > BVH_LEAF) return "a leaf of " + std::to_string(node.count);
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            ++seen.at(i);
            const RayTriangle& t = bvh.triangles()[i];
            if (!holds(node, t.a) || !holds(node, t.b) || !holds(node, t.c)) return "a triangle sticks out of its leaf";
        }
    }
    if (reached != nodes.size()) return "nodes that nobody reaches";
    if (deepest != bvh.depth()) return "depth " + std::to_string(deepest);
    if (deepest > BVH_STACK) return "deeper than a ray remembers";
    for (const int times : seen)
        if (times != 1) return "a triangle in several leaves, or in none";
    if (seen.size() != std::max<size_t>(triangles, 1)) return "triangles are missing";
    return {};
}

std::vector<RayTriangle> random_triangles(size_t count, double size_m) {
    Random random;
    std::vector<RayTriangle> triangles;
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const auto near = [&] { return at + float(size_m) * random.direction(); };
        triangles.push_back(triangle(near(), near(), near()));
    }
    return triangles;
}

}  // namespace

TEST_CASE("a hierarchy holds every triangle once, in boxes that hold what is below") {
    for (const size_t count : {1, 2, 3, 4, 5, 6, 7, 8, 9, 31, 1000})
        for (const double size_m : {0.0, 0.01, 3.0}) {
            INFO(count << " triangles of " << size_m);
            CHECK(wrong_in(Bvh(random_triangles(count, size_m)), count) == "");
        }
    for (const char* model : {"models/sphere.obj", "models/teapot.obj", "models/car.obj"}) {
        const auto triangles = triangles_of(model);
        CHECK(wrong_in(Bvh(triangles), triangles.size()) == "");
    }
}

TEST_CASE("a hierarchy of many triangles, of points and of equal ones among them, is whole") {
    auto triangles = random_triangles(70'000, 0.01);
    for (const RayTriangle& t : random_triangles(3000, 0)) triangles.push_back({t.a, t.a, t.a, NO_CUTOUT});
    triangles.insert(triangles.end(), 5000, triangles[0]);
    CHECK(wrong_in(Bvh(triangles), triangles.size()) == "");
}

TEST_CASE("an even spread makes no branch much deeper than a tree of halves, with leaves of four") {
    CHECK(Bvh(random_triangles(70'000, 0.01)).depth() <= 15 + 8);
}

TEST_CASE("input that gives a hierarchy nothing to go by") {
    CHECK(wrong_in(Bvh(), 0) == "");
    CHECK(Bvh().triangles().size() == 1);  // of no area
    const auto same = std::vector<RayTriangle>(5000, triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
    CHECK(wrong_in(Bvh(same), same.size()) == "");
    CHECK(Bvh(same).depth() <= 11);  // halves: 5000 in leaves of 4
    const auto stack = std::vector<RayTriangle>(5000, triangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1}));
    CHECK(wrong_in(Bvh(stack), stack.size()) == "");
    // So near each other that a bin of the space between them has no width in floats.
    std::vector<RayTriangle> tiny;
    for (int i = 0; i < 40; ++i) {
        const float at = float(i) * 1e-41f;
        tiny.push_back(triangle({at, 0, 0}, {at, 1, 0}, {at, 0, 1}));
    }
    CHECK(wrong_in(Bvh(tiny), tiny.size()) == "");
    // Each twice as large as the one before and around it: a greedy split takes one off at a time.
    std::vector<RayTriangle> nested;
    for (int i = -100; i < 39; ++i) {
        const float r = std::ldexp(1.0f, i);
        for (int k = 0; k < 8; ++k) nested.push_back(triangle({r, 0, 0}, {0, r, 0}, {0, 0, r}));
    }
    CHECK(wrong_in(Bvh(nested), nested.size()) == "");
    CHECK(Bvh(nested).depth() > 20);
}

TEST_CASE("triangles ever farther away: one leaves with each branch, and the rest stays large") {
    std::vector<RayTriangle> triangles = random_triangles(20'000, 0.001);
    for (float far_m = 2; far_m < 1e11f; far_m *= 1.5f)
        triangles.push_back(triangle({far_m, 0, 0}, {far_m, 1, 0}, {far_m, 0, 1}));
    CHECK(wrong_in(Bvh(triangles), triangles.size()) == "");
}

TEST_CASE("a corner that is no place is refused, by name, and a refit leaves all as it was") {
    std::vector<RayTriangle> triangles = random_triangles(10, 1);
    Bvh bvh(triangles);
    const BvhNode root = bvh.nodes()[0];
    for (const float bad : {NAN, INFINITY, -INFINITY, 2e12f}) {
        auto wrong = triangles;
        wrong[7].b.y = bad;
        CHECK_THROWS_AS(Bvh(wrong), InputError);
        CHECK_THROWS_WITH(bvh.refit(wrong), Catch::Matchers::Contains("triangle 7"));
        CHECK(bvh.nodes()[0].lower == root.lower);
    }
    triangles[0].a = glm::vec3(1e12f);
    CHECK(wrong_in(Bvh(triangles), triangles.size()) == "");
    CHECK_THROWS_AS(bvh.refit({}), Failure);
}

TEST_CASE("a refit puts every triangle where it moved, in the tree that was") {
    auto before = random_triangles(500, 0.1);
    for (uint32_t i = 0; i < before.size(); ++i) before[i].cutout = i;  // by which to know each again
    Bvh bvh(before);
    auto after = before;
    for (RayTriangle& t : after)
        for (glm::vec3* p : {&t.a, &t.b, &t.c}) *p = glm::vec3(-p->z, 3.0f * p->y, p->x + 10.0f);
    for (RayTriangle& t : after) t.cutout = NO_CUTOUT;  // cut-outs are excluded from the comparison
    const size_t nodes = bvh.nodes().size();
    bvh.refit(after);
    CHECK(wrong_in(bvh, after.size()) == "");
    CHECK(bvh.nodes().size() == nodes);
    size_t elsewhere = 0;
    for (const RayTriangle& t : bvh.triangles()) elsewhere += t.a != after.at(t.cutout).a || t.c != after[t.cutout].c;
    CHECK(elsewhere == 0);
    CHECK(bounds_of(bvh.triangles()).lower == bounds_of(after).lower);
    CHECK(bounds_of(bvh.triangles()).upper == bounds_of(after).upper);
}
