// Growing of a bounding volume hierarchy on several threads.
#pragma once
#include <vector>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {

struct GrownBvh {
    std::vector<BvhNode> nodes;
    std::vector<RayTriangle> triangles;
    std::vector<uint32_t> order;  ///< for each triangle its place in the given ones
    uint32_t depth = 0;
    bool is_finite = true;  ///< false: a corner is no place within Bvh::farthest_m, and there is no hierarchy
};

/// Of at least one triangle. The result does not depend on the number of threads, to the bit.
GrownBvh grow_bvh(const std::vector<RayTriangle>& triangles, unsigned threads);

/// By which the boxes of leaves are larger: a flat box has no inside, and rounding would let a ray along it pass.
/// `farthest`: coordinate.
inline float box_margin(float farthest) { return farthest * 0x1p-22f + 1e-30f; }

}  // namespace lightwalk
