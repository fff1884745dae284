// Splitting of a run of boxes in two, for a bounding volume hierarchy.
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "common/scene/mesh.h"

namespace lightwalk {

/// A triangle's box, and in the fourth number of `lower` its place, below 2^30: four floats are one register. A bit
/// above keeps that number normal, since processors take a hundred cycles for denormal ones.
struct Boxed {
    using Four = float __attribute__((vector_size(16)));
    static constexpr uint32_t is_normal = 1u << 30;
    Four lower, upper;

    Boxed() = default;
    Boxed(const Bounds& box, uint32_t index)
        : lower{box.lower.x, box.lower.y, box.lower.z, std::bit_cast<float>(index | is_normal)},
          upper{box.upper.x, box.upper.y, box.upper.z, 0.0f} {}
    uint32_t index() const { return std::bit_cast<uint32_t>(lower[3]) & ~is_normal; }
    Four center() const { return 0.5f * lower + 0.5f * upper; }
    float center(int axis) const { return 0.5f * lower[axis] + 0.5f * upper[axis]; }
};
using Run = std::vector<Boxed>::iterator;

/// Orders a run of at least one so that those of the lower side come first, and returns where the upper side begins;
/// `end` where the run is to be a leaf. `levels` may still come below.
Run split(Run begin, Run end, uint32_t levels);

}  // namespace lightwalk
