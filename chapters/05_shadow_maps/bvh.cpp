#include "05_shadow_maps/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

#include "05_shadow_maps/bvh_split.h"
#include "common/base/error.h"
#include "common/base/turn.h"

namespace lightwalk {
namespace {

Bounds box_of(const RayTriangle& t) {
    Bounds box;
    for (const glm::vec3& corner : {t.a, t.b, t.c}) box.add(corner);
    return box;
}

void check(const std::vector<RayTriangle>& triangles) {
    for (size_t i = 0; i < triangles.size(); ++i)
        for (const glm::vec3& p : {triangles[i].a, triangles[i].b, triangles[i].c})
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::fabs(p[axis]) <= Bvh::farthest_m))
                    throw InputError("triangle {} has a corner at ({}, {}, {}) m, expected numbers from -1e12 to 1e12",
                                     i, p.x, p.y, p.z);
}

// A part of the tree, its root first. Leaves count triangles of the whole.
struct Grown {
    std::vector<BvhNode> nodes{1};
    uint32_t depth = 0;
};

Grown grow(Run all, Run begin, Run end, uint32_t depth) {
    Grown grown;
    struct Task {
        uint32_t node, depth;
        Run begin, end;
    };
    std::vector<Task> tasks{{0, depth, begin, end}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        grown.depth = std::max(grown.depth, task.depth);
        const Run middle = split(task.begin, task.end, BVH_STACK - task.depth);
        if (middle == task.end) {
            grown.nodes[task.node].first = static_cast<uint32_t>(task.begin - all);
            grown.nodes[task.node].count = static_cast<uint32_t>(task.end - task.begin);
            continue;
        }
        const auto child = static_cast<uint32_t>(grown.nodes.size());
        grown.nodes[task.node].first = child;
        grown.nodes.resize(grown.nodes.size() + 2);
        tasks.push_back({child + 1, task.depth + 1, middle, task.end});
        tasks.push_back({child, task.depth + 1, task.begin, middle});
    }
    return grown;
}

// Both sides below one root. Children stand side by side, then what is below the first, then below the second.
Grown joined(const Grown& lower, const Grown& upper) {
    Grown both{.nodes = {{.first = 1}, lower.nodes[0], upper.nodes[0]}, .depth = std::max(lower.depth, upper.depth)};
    const auto add = [&](const Grown& side, BvhNode& root) {
        const auto shift = static_cast<uint32_t>(both.nodes.size() - 1);
        if (root.count == 0) root.first += shift;
        for (size_t i = 1; i < side.nodes.size(); ++i) {
            both.nodes.push_back(side.nodes[i]);
            if (side.nodes[i].count == 0) both.nodes.back().first += shift;
        }
    };
    both.nodes.reserve(lower.nodes.size() + upper.nodes.size() + 1);
    add(lower, both.nodes[1]);
    add(upper, both.nodes[2]);
    return both;
}

// At the same time where a thread can be had, and afterwards where none can.
std::future<Grown> at_the_same_time(bool wanted, std::function<Grown()> work) {
    if (wanted) try {
            return std::async(std::launch::async, work);
        } catch (const std::system_error&) {}
    return std::async(std::launch::deferred, work);
}

// Large sides grow at the same time, where there are cores; the tree does not depend on that.
Grown grow_sides(Run all, Run begin, Run end, uint32_t depth) {
    constexpr auto large = 1 << 14;
    const Run middle = end - begin < large ? end : split(begin, end, BVH_STACK - depth);
    if (middle == end) return grow(all, begin, end, depth);
    // std::bit_width returns the argument's type or, since LWG 3656, an int.
    const auto halvings = uint32_t(std::bit_width(std::max(std::thread::hardware_concurrency(), 1u) - 1));
    auto upper = at_the_same_time(depth < halvings, [=] { return grow_sides(all, middle, end, depth + 1); });
    const Grown lower = grow_sides(all, begin, middle, depth + 1);
    return joined(lower, upper.get());
}

}  // namespace

Bvh::Bvh(std::vector<RayTriangle> triangles) {
    Turn::works(triangles.size());
    check(triangles);
    if (triangles.empty()) triangles.push_back({.cutout = NO_CUTOUT});
    std::vector<Boxed> boxed;
    boxed.reserve(triangles.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) boxed.emplace_back(box_of(triangles[i]), i);
    Grown grown = grow_sides(boxed.begin(), boxed.begin(), boxed.end(), 0);
    nodes_ = std::move(grown.nodes);
    depth_ = grown.depth;
    if (depth_ > BVH_STACK)
        throw Failure("the hierarchy has {} levels; rays can traverse at most {}", depth_, BVH_STACK);
    order_.reserve(boxed.size());
    triangles_.reserve(boxed.size());
    for (const Boxed& b : boxed) {
        order_.push_back(b.index());
        triangles_.push_back(triangles[b.index()]);
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
