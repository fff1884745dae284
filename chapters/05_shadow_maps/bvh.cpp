#include "05_shadow_maps/bvh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "05_shadow_maps/bvh_grow.h"
#include "common/base/error.h"
#include "common/scene/mesh.h"

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

}  // namespace

Bvh::Bvh(const std::vector<RayTriangle>& triangles, unsigned threads) {
    GrownBvh grown = grow_bvh(triangles.empty() ? std::vector{RayTriangle{.cutout = NO_CUTOUT}} : triangles, threads);
    if (!grown.is_finite) check(triangles);
    nodes_ = std::move(grown.nodes);
    triangles_ = std::move(grown.triangles);
    order_ = std::move(grown.order);
    depth_ = grown.depth;
    if (depth_ > BVH_STACK)
        throw Failure("the hierarchy has {} levels; rays can traverse at most {}", depth_, BVH_STACK);
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
    const glm::vec3 margin(box_margin(farthest));
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
