// Growing of a bounding volume hierarchy on several threads.
#pragma once
#include <vector>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {

struct GrownBvh {
    std::vector<BvhNode> nodes;
    std::vector<RayTriangle> triangles;
    std::vector<uint32_t> order;  ///< input index of each triangle
    uint32_t depth = 0;
    bool is_finite = true;  ///< false: a corner beyond Bvh::farthest_m or not finite; no hierarchy
};

/// Hierarchy of at least one triangle. Equal to the bit for any number of threads.
GrownBvh grow_bvh(const std::vector<RayTriangle>& triangles, unsigned threads);

/// Enlargement of leaf boxes: a ray along a flat box would miss it by rounding. `farthest`: largest coordinate.
inline float box_margin(float farthest) { return farthest * 0x1p-22f + 1e-30f; }

}  // namespace lightwalk
