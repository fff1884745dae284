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

/// A box in the first three numbers of each: four floats are one register.
struct WideBox {
    using Four = float __attribute__((vector_size(16)));
    Four lower = Four{} + 1e30f, upper = Four{} - 1e30f;

    void add(const Four& from, const Four& to) {
        lower = from < lower ? from : lower;
        upper = to > upper ? to : upper;
    }
    void add(const WideBox& other) { add(other.lower, other.upper); }
    /// Half of the surface; in double precision, for the square of a planet's size is no float.
    double area() const {
        const Four e = upper - lower;
        const double x = e[0], y = e[1], z = e[2];
        return x * y + y * z + z * x;
    }
};

/// The corner and the number behind it: a triangle's last corner has one too.
inline WideBox::Four wide_corner(const RayTriangle& triangle, size_t i) {
    WideBox::Four four;
    std::memcpy(&four, reinterpret_cast<const std::byte*>(&triangle) + i * sizeof(glm::vec3), sizeof four);
    return four;
}

/// A triangle's box, and in the fourth number of `lower` its place, below 2^30. A bit above keeps that number normal,
/// since processors take a hundred cycles for denormal ones.
struct Boxed : WideBox {
    static constexpr uint32_t is_normal = 1u << 30;
    void set_place(uint32_t place) {
        lower[3] = std::bit_cast<float>(place | is_normal);
        upper[3] = 0;
    }
    uint32_t place() const { return std::bit_cast<uint32_t>(lower[3]) & ~is_normal; }
};

/// Of a run of boxes. Centres are twice as large as they are, here and below, which saves their halving.
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

/// The grid of bins over a run's centres.
struct BinGrid {
    static constexpr int bins = 16;
    WideBox::Four origin, bins_per_m;

    explicit BinGrid(const WideBox& centers);
    /// An extent along this axis.
    bool has(int axis) const { return bins_per_m[axis] > 0; }
};

/// A border between bins.
struct BinCut {
    int axis = -1;       ///< -1: none
    int bin = 0;         ///< the first on the upper side
    uint32_t below = 0;  ///< boxes on the lower side
    double cost = INFINITY;
    explicit operator bool() const { return axis >= 0; }
};

/// What lies in each bin of each axis.
struct Bins {
    std::array<std::array<WideBox, BinGrid::bins>, 3> box;
    std::array<std::array<uint32_t, BinGrid::bins>, 3> count{};

    void add(std::span<const Boxed> run, const BinGrid& grid);
    void add(const Bins& other);
    BinCut best_cut(const BinGrid& grid) const;
    uint32_t below(const BinCut& cut) const;
};

/// The cheapest border for the run, as its Bins would say.
BinCut best_cut(std::span<const Boxed> run, const BinGrid& grid);

/// Copies each side in its order. Returns how many lie on the lower one.
size_t part_boxes(std::span<const Boxed> run, const BinGrid& grid, const BinCut& cut, Boxed* lower, Boxed* upper);

/// Orders the run so that the first half lies lower, along the axis with the widest spread.
void halve_boxes(std::span<Boxed> run, const WideBox& centers);

/// How many levels a tree of halves needs for so many triangles.
inline uint32_t levels_of_halves(uint32_t count) {
    // std::bit_width returns the argument's type or, since LWG 3656, an int.
    return uint32_t(std::bit_width((count + BVH_LEAF - 1) / BVH_LEAF - 1u));
}

}  // namespace lightwalk
