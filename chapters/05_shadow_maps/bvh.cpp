#include "05_shadow_maps/bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "common/base/error.h"
#include "common/scene/mesh.h"

namespace lightwalk {
namespace {

constexpr int bin_count = 16;

struct Boxed {
    Bounds box;
    glm::vec3 center{0.0f};
    uint32_t index = 0;
};
using Run = std::vector<Boxed>::iterator;

Bounds box_of(const RayTriangle& t) {
    Bounds box;
    for (const glm::vec3& corner : {t.a, t.b, t.c}) box.add(corner);
    return box;
}

// Half of its surface; in double precision, for the square of a planet's size is no float.
double area(const Bounds& box) {
    if (box.empty()) return 0;
    const glm::dvec3 e(box.extent());
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

void check(const std::vector<RayTriangle>& triangles) {
    for (size_t i = 0; i < triangles.size(); ++i)
        for (const glm::vec3& p : {triangles[i].a, triangles[i].b, triangles[i].c})
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::fabs(p[axis]) <= Bvh::farthest_m))
                    throw InputError("triangle {} has a corner at ({}, {}, {}) m, expected numbers from -1e12 to 1e12",
                                     i, p.x, p.y, p.z);
}

struct Bin {
    Bounds box;
    uint32_t count = 0;
};

struct Cut {
    int axis = -1;  ///< -1: none
    int bin = 0;    ///< the first on the upper side
    double cost = INFINITY;
    float origin = 0, bins_per_m = 0;
    int bin_of(const Boxed& b) const {
        return std::min(static_cast<int>((b.center[axis] - origin) * bins_per_m), bin_count - 1);
    }
};

// The best cut along one axis, where it is cheaper than `best`.
void try_axis(Run begin, Run end, const Bounds& centers, int axis, Cut& best) {
    Cut cut{.axis = axis, .origin = centers.lower[axis]};
    const float extent = centers.upper[axis] - centers.lower[axis];
    cut.bins_per_m = bin_count / extent;
    if (!(extent > 0) || !std::isfinite(cut.bins_per_m)) return;
    std::array<Bin, bin_count> bins;
    for (Run i = begin; i != end; ++i) {
        Bin& bin = bins[static_cast<size_t>(cut.bin_of(*i))];
        bin.box.add(i->box);
        ++bin.count;
    }
    std::array<double, bin_count> upper_cost{};
    Bin upper;
    for (size_t i = bin_count - 1; i > 0; --i) {
        upper.box.add(bins[i].box);
        upper.count += bins[i].count;
        upper_cost[i] = area(upper.box) * upper.count;
    }
    Bin lower;
    const auto total = static_cast<uint32_t>(end - begin);
    for (size_t i = 1; i < bin_count; ++i) {
        lower.box.add(bins[i - 1].box);
        lower.count += bins[i - 1].count;
        cut.cost = area(lower.box) * lower.count + upper_cost[i];
        cut.bin = static_cast<int>(i);
        if (lower.count > 0 && lower.count < total && cut.cost < best.cost) best = cut;
    }
}

// How many levels a tree of halves needs for so many triangles.
uint32_t levels_of_halves(uint32_t count) { return std::bit_width((count + BVH_LEAF - 1) / BVH_LEAF - 1u); }

// Where the upper side begins; `end` where the run is to be a leaf. `levels` may still come below.
Run split(Run begin, Run end, uint32_t levels) {
    Bounds box, centers;
    for (Run i = begin; i != end; ++i) {
        box.add(i->box);
        centers.add(i->center);
    }
    const auto count = static_cast<uint32_t>(end - begin);
    Cut best;
    if (levels_of_halves(count) < levels)
        for (int axis = 0; axis < 3; ++axis) try_axis(begin, end, centers, axis, best);
    // Going down costs as much as one triangle.
    const bool helps = best.axis >= 0 && area(box) + best.cost < area(box) * count;
    if (count <= BVH_LEAF && !helps) return end;
    if (best.axis >= 0) return std::partition(begin, end, [&](const Boxed& b) { return best.bin_of(b) < best.bin; });
    const glm::vec3 extent = centers.extent();
    const int widest = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Run middle = begin + count / 2;
    std::nth_element(begin, middle, end,
                     [&](const Boxed& a, const Boxed& b) { return a.center[widest] < b.center[widest]; });
    return middle;
}

}  // namespace

Bvh::Bvh(std::vector<RayTriangle> triangles) {
    check(triangles);
    if (triangles.empty()) triangles.push_back({.cutout = NO_CUTOUT});
    std::vector<Boxed> boxed(triangles.size());
    for (uint32_t i = 0; i < boxed.size(); ++i) {
        const Bounds box = box_of(triangles[i]);
        boxed[i] = {box, 0.5f * box.lower + 0.5f * box.upper, i};
    }
    struct Task {
        uint32_t node, first, count, depth;
    };
    nodes_.push_back({});
    std::vector<Task> tasks{{0, 0, static_cast<uint32_t>(boxed.size()), 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        depth_ = std::max(depth_, task.depth);
        const Run begin = boxed.begin() + task.first, end = begin + task.count;
        const auto below = static_cast<uint32_t>(split(begin, end, BVH_STACK - task.depth) - begin);
        if (below == task.count) {
            nodes_[task.node].first = task.first;
            nodes_[task.node].count = task.count;
            continue;
        }
        const auto child = static_cast<uint32_t>(nodes_.size());
        nodes_[task.node].first = child;
        nodes_[task.node].count = 0;
        nodes_.resize(nodes_.size() + 2);
        tasks.push_back({child + 1, task.first + below, task.count - below, task.depth + 1});
        tasks.push_back({child, task.first, below, task.depth + 1});
    }
    if (depth_ > BVH_STACK)
        throw Failure("the hierarchy has {} levels; rays can traverse at most {}", depth_, BVH_STACK);
    for (const Boxed& b : boxed) {
        order_.push_back(b.index);
        triangles_.push_back(triangles[b.index]);
    }
    set_boxes();
}

// [refit]
void Bvh::refit(const std::vector<RayTriangle>& moved) {
    check(moved);
    if (moved.empty() && triangles_.size() == 1) return;
    if (moved.size() != triangles_.size())
        throw Failure("refit with {} triangles; the hierarchy has {}", moved.size(), triangles_.size());
    for (size_t i = 0; i < order_.size(); ++i) {
        const RayTriangle& to = moved[order_[i]];
        triangles_[i] = {to.a, to.b, to.c, triangles_[i].cutout};
    }
    set_boxes();
}

void Bvh::set_boxes() {
    float farthest = 0;
    for (const RayTriangle& t : triangles_)
        for (const glm::vec3& p : {t.a, t.b, t.c})
            for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::fabs(p[axis]));
    // A flat box has no inside: rounding would let a ray along it pass.
    const glm::vec3 margin(farthest * 0x1p-22f + 1e-30f);
    for (size_t i = nodes_.size(); i-- > 0;) {  // children before their parents
        BvhNode& node = nodes_[i];
        Bounds box;
        if (node.count == 0) {
            for (const BvhNode& child : {nodes_[node.first], nodes_[node.first + 1]}) {
                box.add(child.lower);
                box.add(child.upper);
            }
        } else {
            for (uint32_t t = 0; t < node.count; ++t) box.add(box_of(triangles_[node.first + t]));
            box.lower -= margin;
            box.upper += margin;
        }
        node.lower = box.lower;
        node.upper = box.upper;
    }
}
// [/refit]

}  // namespace lightwalk
