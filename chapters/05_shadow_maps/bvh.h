// Bounding volume hierarchy over the triangles of a scene, which saves rays from testing every triangle.
#pragma once
#include <span>
#include <vector>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {

/// Top-down build: smallest surface-area cost among the borders of 16 bins along each axis (I. Wald, "On fast
/// Construction of SAH-based Bounding Volume Hierarchies", RT 2007). If no border helps, or the branch would exceed
/// BVH_STACK, the triangles are halved, so depth is bounded for any input.
class Bvh {
  public:
    /// `triangles` may be empty; degenerate ones are never hit. Throws InputError for a corner that is not finite or
    /// farther than `farthest_m` from the origin.
    explicit Bvh(const std::vector<RayTriangle>& triangles = {});

    /// Refits boxes to moved triangles, in the constructor's order; tree and cut-outs stay. Large motions make rays
    /// slower, never wrong. Throws InputError as the constructor does, with nothing changed.
    void refit(const std::vector<RayTriangle>& moved);

    /// Nodes, parents before children; at least the root.
    std::span<const BvhNode> nodes() const { return {nodes_.data(), nodes_.size()}; }
    /// Triangles in leaf order; a degenerate one if there are none.
    std::span<const RayTriangle> triangles() const { return {triangles_.data(), triangles_.size()}; }
    /// Constructor's index of each of triangles().
    const std::vector<uint32_t>& order() const { return order_; }
    /// Depth of the deepest leaf, at most BVH_STACK; the root's is 0.
    uint32_t depth() const { return depth_; }

    static constexpr float farthest_m = 1e12f;

  private:
    void set_boxes();
    std::vector<BvhNode> nodes_;
    std::vector<RayTriangle> triangles_;
    std::vector<uint32_t> order_;  ///< constructor's index of each of triangles_
    uint32_t depth_ = 0;
};

}  // namespace lightwalk
