// Bounding volume hierarchy over the triangles of a scene, which saves rays from testing every triangle.
#pragma once
#include <span>
#include <vector>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {

// [bvh]
/// Built top down: of 16 bins along each axis, the border with the smallest surface-area cost (I. Wald, "On fast
/// Construction of SAH-based Bounding Volume Hierarchies", RT 2007). If no border helps, or the branch would grow
/// deeper than BVH_STACK, the triangles are halved: so the depth is bounded for any input. All threads together split
/// large parts; each small one grows in one thread.
class Bvh {
  public:
    /// There may be none; triangles without area are kept and never hit. Throws InputError for a corner that is not a
    /// number, or is farther than `farthest_m` from the origin. `threads` (0: one for each core) do not affect the
    /// result.
    explicit Bvh(const std::vector<RayTriangle>& triangles = {}, unsigned threads = 0);

    /// The same triangles moved, in the constructor's order: boxes follow, tree and cut-outs stay. Triangles that
    /// move far from their neighbours make rays slower, never wrong. Throws InputError, as the constructor, with
    /// nothing changed.
    void refit(const std::vector<RayTriangle>& moved);

    /// The root first, and parents before their children; at least one.
    std::span<const BvhNode> nodes() const { return {nodes_.data(), nodes_.size()}; }
    /// As leaves count them; one of no area where there is none.
    std::span<const RayTriangle> triangles() const { return {triangles_.data(), triangles_.size()}; }
    /// For each of triangles() its place in the constructor's list.
    const std::vector<uint32_t>& order() const { return order_; }
    /// Of the deepest leaf; the root's is 0. At most BVH_STACK.
    uint32_t depth() const { return depth_; }

    static constexpr float farthest_m = 1e12f;

  private:
    void set_boxes();
    std::vector<BvhNode> nodes_;
    std::vector<RayTriangle> triangles_;
    std::vector<uint32_t> order_;  ///< for each of triangles_ its place in the constructor's list
    uint32_t depth_ = 0;
};
// [/bvh]

}  // namespace lightwalk
