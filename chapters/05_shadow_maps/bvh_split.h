// Splitting of a run of boxes in two, for a bounding volume hierarchy.
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {

/// Box in the first three components: four floats fill a register.
struct WideBox {
    using Four = float __attribute__((vector_size(16)));
    Four lower = Four{} + 1e30f, upper = Four{} - 1e30f;

    void add(const Four& from, const Four& to) {
        lower = from < lower ? from : lower;
        upper = to > upper ? to : upper;
    }
    void add(const WideBox& other) { add(other.lower, other.upper); }
    /// Half the surface area, in double precision: a planet's squared size exceeds float.
    double area() const {
        const Four e = upper - lower;
        const double x = e[0], y = e[1], z = e[2];
        return x * y + y * z + z * x;
    }
};

/// Loads a corner and the float behind it, which a triangle's last corner has too.
inline WideBox::Four wide_corner(const RayTriangle& triangle, size_t i) {
    WideBox::Four four;
    std::memcpy(&four, reinterpret_cast<const std::byte*>(&triangle) + i * sizeof(glm::vec3), sizeof four);
    return four;
}

/// Triangle's box, with its index, below 2^30, in the fourth component of `lower`. A higher bit keeps that float
/// normal, since denormals cost processors a hundred cycles.
struct Boxed : WideBox {
    static constexpr uint32_t is_normal = 1u << 30;
    void set_place(uint32_t place) {
        lower[3] = std::bit_cast<float>(place | is_normal);
        upper[3] = 0;
    }
    uint32_t place() const { return std::bit_cast<uint32_t>(lower[3]) & ~is_normal; }
};

/// Bounds of a run of boxes. Centres are doubled throughout, which saves halving them.
struct Extent {
    WideBox box, centers;
    void add(const Boxed& b) {
        const WideBox::Four center = b.lower + b.upper;
        box.add(b);
        centers.add(center, center);
    }
    void add(const Extent& other) {
        box.add(other.box);
        centers.add(other.centers);
    }
};
Extent extent_of(std::span<const Boxed> run);

/// Bins over a run's centres.
struct BinGrid {
    static constexpr int bins = 16;
    WideBox::Four origin, bins_per_m;

    explicit BinGrid(const WideBox& centers);
    /// Extent along an axis.
    bool has(int axis) const { return bins_per_m[axis] > 0; }
};

/// Border between bins.
struct BinCut {
    int axis = -1;       ///< -1: none
    int bin = 0;         ///< first bin on the upper side
    uint32_t below = 0;  ///< number of boxes on the lower side
    double cost = INFINITY;
    explicit operator bool() const { return axis >= 0; }
};

/// Contents of the bins of each axis.
struct Bins {
    std::array<std::array<WideBox, BinGrid::bins>, 3> box;
    std::array<std::array<uint32_t, BinGrid::bins>, 3> count{};

    void add(std::span<const Boxed> run, const BinGrid& grid);
    void add(const Bins& other);
    BinCut best_cut(const BinGrid& grid) const;
    uint32_t below(const BinCut& cut) const;
};

/// Cheapest border of the run.
BinCut best_cut(std::span<const Boxed> run, const BinGrid& grid);

/// Stable partition; returns the number on the lower side.
size_t part_boxes(std::span<const Boxed> run, const BinGrid& grid, const BinCut& cut, Boxed* lower, Boxed* upper);

/// Partition at the median along the axis of the widest spread.
void halve_boxes(std::span<Boxed> run, const WideBox& centers);

/// Depth of a tree of halves over so many triangles.
inline uint32_t levels_of_halves(uint32_t count) {
    // std::bit_width returns the argument's type or, since LWG 3656, an int.
    return uint32_t(std::bit_width((count + BVH_LEAF - 1) / BVH_LEAF - 1u));
}

}  // namespace lightwalk
