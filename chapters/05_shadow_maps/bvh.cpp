#include "05_shadow_maps/bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/base/error.h"
#include "common/scene/mesh.h"

namespace lightwalk {
namespace {

// Box in the first three components: four floats fill a register.
struct WideBox {
    using Four = float __attribute__((vector_size(16)));
    Four lower = Four{} + 1e30f, upper = Four{} - 1e30f;

    void add(const Four& from, const Four& to) {
        lower = from < lower ? from : lower;
        upper = to > upper ? to : upper;
    }
    void add(const WideBox& other) { add(other.lower, other.upper); }
    // Half the surface area, in double precision: a planet's squared size exceeds float.
    double area() const {
        const Four e = upper - lower;
        const double x = e[0], y = e[1], z = e[2];
        return x * y + y * z + z * x;
    }
};

// Loads a corner and the float behind it, which a triangle's last corner has too.
WideBox::Four wide_corner(const RayTriangle& triangle, size_t i) {
    WideBox::Four four;
    std::memcpy(&four, reinterpret_cast<const std::byte*>(&triangle) + i * sizeof(glm::vec3), sizeof four);
    return four;
}

// Triangle's box, with its index, below 2^30, in the fourth component of `lower`. A higher bit keeps that float
// normal, since denormals cost processors a hundred cycles.
struct Boxed : WideBox {
    static constexpr uint32_t is_normal = 1u << 30;
    Boxed() = default;
    Boxed(const RayTriangle& triangle, uint32_t place) {
        for (size_t i = 0; i < 3; ++i) add(wide_corner(triangle, i), wide_corner(triangle, i));
        lower[3] = std::bit_cast<float>(place | is_normal);
        upper[3] = 0;
    }
    uint32_t place() const { return std::bit_cast<uint32_t>(lower[3]) & ~is_normal; }
};

// Bounds of a run of boxes. Centres are doubled throughout, which saves halving them.
struct Extent {
    WideBox box, centers;
    void add(const Boxed& b) {
        const WideBox::Four center = b.lower + b.upper;
        box.add(b);
        centers.add(center, center);
    }
};

// Bins over a run's centres.
struct BinGrid {
    static constexpr int bins = 16;
    WideBox::Four origin, bins_per_m;

    explicit BinGrid(const WideBox& centers);
    // Extent along an axis.
    bool has(int axis) const { return bins_per_m[axis] > 0; }
};

// Border between bins.
struct BinCut {
    int axis = -1;       //< -1: none
    int bin = 0;         //< first bin on the upper side
    uint32_t below = 0;  //< number of boxes on the lower side
    double cost = INFINITY;
    explicit operator bool() const { return axis >= 0; }
};

// Contents of the bins of each axis.
struct Bins {
    std::array<std::array<WideBox, BinGrid::bins>, 3> box;
    std::array<std::array<uint32_t, BinGrid::bins>, 3> count{};

    void add(std::span<const Boxed> run, const BinGrid& grid);
    BinCut best_cut(const BinGrid& grid) const;
};

// Depth of a tree of halves over so many triangles.
uint32_t levels_of_halves(uint32_t count) {
    // std::bit_width returns the argument's type or, since LWG 3656, an int.
    return uint32_t(std::bit_width((count + BVH_LEAF - 1) / BVH_LEAF - 1u));
}

using Four = WideBox::Four;
using Numbers = int32_t __attribute__((vector_size(16)));

Numbers bins_of(const Boxed& b, const BinGrid& grid) {
    constexpr auto last = static_cast<float>(BinGrid::bins - 1);
    const Four at = (b.lower + b.upper - grid.origin) * grid.bins_per_m;
    const Four most = Four{} + last;
    return __builtin_convertvector(at < most ? at : most, Numbers);
}

// Boxes in one bin.
struct Place {
    const WideBox* box;
    uint32_t count;
    int bin;
};

// Best cut along one axis, if cheaper than `best`. Indices come in the order of their bins.
void try_axis(std::span<const Place> places, int axis, BinCut& best) {
    std::array<double, BinGrid::bins> upper_cost;
    WideBox upper;
    uint32_t count = 0;
    for (size_t i = places.size(); i-- > 1;) {
        upper.add(*places[i].box);
        count += places[i].count;
        upper_cost[i] = upper.area() * count;
    }
    WideBox lower;
    count = 0;
    for (size_t i = 1; i < places.size(); ++i) {
        lower.add(*places[i - 1].box);
        count += places[i - 1].count;
        if (places[i].bin == places[i - 1].bin) continue;
        const double cost = lower.area() * count + upper_cost[i];
        if (cost < best.cost) best = {axis, places[i].bin, count, cost};
    }
}

// Number of boxes below which sorting by bins is faster.
constexpr size_t few = 8;

BinCut best_cut_of_few(std::span<const Boxed> run, const BinGrid& grid) {
    // Sort keys per axis: bin and box index.
    std::array<Four, few> keys;
    for (size_t i = 0; i < run.size(); ++i) {
        keys[i] = __builtin_convertvector(bins_of(run[i], grid) * int(few) + int(i), Four);
        for (size_t k = i; k > 0; --k) {
            const Four a = keys[k - 1], b = keys[k];
            keys[k - 1] = a < b ? a : b;
            keys[k] = a < b ? b : a;
        }
    }
    std::array<Numbers, few> sorted;
    for (size_t i = 0; i < run.size(); ++i) sorted[i] = __builtin_convertvector(keys[i], Numbers);
    std::array<Place, few> places;
    BinCut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!grid.has(axis)) continue;
        for (size_t i = 0; i < run.size(); ++i) {
            const auto key = static_cast<unsigned>(sorted[i][axis]);
            places[i] = {&run[key % few], 1, int(key / few)};
        }
        try_axis({places.data(), run.size()}, axis, best);
        if (best && run.size() == 2) break;  // other axes give the same cut
    }
    return best;
}

Extent extent_of(std::span<const Boxed> run) {
    Extent extent;
    for (const Boxed& b : run) extent.add(b);
    return extent;
}

BinGrid::BinGrid(const WideBox& centers) : origin(centers.lower) {
    Four extent = centers.upper - centers.lower;
    extent[3] = 0;
    const Four scale = bins / extent;
    bins_per_m = (extent > 0) & (scale <= std::numeric_limits<float>::max()) ? scale : Four{};
}

void Bins::add(std::span<const Boxed> run, const BinGrid& grid) {
    const auto put = [&](size_t axis, int at, const Boxed b) {
        const auto bin = static_cast<size_t>(at);
        box[axis][bin].add(b);
        ++count[axis][bin];
    };
    for (const Boxed b : run) {
        const Numbers at = bins_of(b, grid);
        put(0, at[0], b);
        put(1, at[1], b);
        put(2, at[2], b);
    }
}

// Borders behind empty bins repeat the previous cut.
BinCut Bins::best_cut(const BinGrid& grid) const {
    BinCut best;
    std::array<Place, BinGrid::bins> places;
    for (int axis = 0; axis < 3; ++axis) {
        if (!grid.has(axis)) continue;
        size_t used = 0;
        for (int bin = 0; bin < BinGrid::bins; ++bin) {
            const uint32_t inside = count[axis][size_t(bin)];
            places[used] = {&box[axis][size_t(bin)], inside, bin};
            used += inside > 0;
        }
        try_axis({places.data(), used}, axis, best);
    }
    return best;
}

BinCut best_cut(std::span<const Boxed> run, const BinGrid& grid) {
    if (run.size() <= few) return best_cut_of_few(run, grid);
    Bins bins;
    bins.add(run, grid);
    return bins.best_cut(grid);
}

// Stable partition; returns the number on the lower side. Branchless, since the comparison is unpredictable.
size_t part_boxes(std::span<const Boxed> run, const BinGrid& grid, const BinCut& cut, Boxed* lower, Boxed* upper) {
    const float origin = grid.origin[cut.axis], bins_per_m = grid.bins_per_m[cut.axis];
    const auto border = static_cast<float>(cut.bin);
    const auto to_upper = static_cast<size_t>(upper - lower);
    size_t below = 0;
    for (size_t i = 0; i < run.size(); ++i) {
        const Boxed& b = run[i];
        const float center = b.lower[cut.axis] + b.upper[cut.axis];
        const size_t is_below = (center - origin) * bins_per_m < border;
        lower[below + (to_upper + i - 2 * below) * (1 - is_below)] = b;
        below += is_below;
    }
    return below;
}

// Partition at the median along the axis of the widest spread.
void halve_boxes(std::span<Boxed> run, const WideBox& centers) {
    const Four e = centers.upper - centers.lower;
    const int widest = e[0] >= e[1] && e[0] >= e[2] ? 0 : e[1] >= e[2] ? 1 : 2;
    std::nth_element(run.begin(), run.begin() + run.size() / 2, run.end(), [&](const Boxed& a, const Boxed& b) {
        return a.lower[widest] + a.upper[widest] < b.lower[widest] + b.upper[widest];
    });
}

// Enlargement of leaf boxes: a ray along a flat box would miss it by rounding. `farthest`: largest coordinate.
float box_margin(float farthest) { return farthest * 0x1p-22f + 1e-30f; }

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

// Children are adjacent; the first one's branch comes before the second one's.
Bvh::Bvh(const std::vector<RayTriangle>& given) {
    check(given);
    const std::vector<RayTriangle> source = given.empty() ? std::vector{RayTriangle{.cutout = NO_CUTOUT}} : given;
    const auto total = static_cast<uint32_t>(source.size());
    std::vector<Boxed> boxed[2]{std::vector<Boxed>(total), std::vector<Boxed>(total)};  // runs at even and odd depths
    for (uint32_t i = 0; i < total; ++i) boxed[0][i] = Boxed(source[i], i);
    const WideBox all = extent_of(boxed[0]).box;
    float farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::fabs(all.lower[axis]), std::fabs(all.upper[axis])});
    const Four margin = Four{} + box_margin(farthest);
    const auto node = [&](const WideBox& box, uint32_t first, uint32_t count) {
        const Four lower = box.lower - margin, upper = box.upper + margin;
        return BvhNode{{lower[0], lower[1], lower[2]}, first, {upper[0], upper[1], upper[2]}, count};
    };
    struct Task {
        uint32_t node, depth, begin, end;
    };
    std::vector<Task> tasks{{0, 0, 0, total}};
    nodes_.resize(1);
    order_.resize(total);
    while (!tasks.empty()) {
        const auto [at, depth, begin, end] = tasks.back();
        tasks.pop_back();
        const uint32_t count = end - begin;
        const std::span<Boxed> here{&boxed[depth % 2][begin], count};
        const Extent extent = extent_of(here);
        const BinGrid grid(extent.centers);
        const BinCut cut = count > 1 && levels_of_halves(count) < BVH_STACK - depth ? best_cut(here, grid) : BinCut{};
        const double area = extent.box.area();
        // A traversal step costs as much as one triangle test.
        if (count <= BVH_LEAF && !(cut && area + cut.cost < area * count)) {
            nodes_[at] = node(extent.box, begin, count);
            for (uint32_t i = 0; i < count; ++i) order_[begin + i] = here[i].place();
            depth_ = std::max(depth_, depth);
            continue;
        }
        const auto child = static_cast<uint32_t>(nodes_.size());
        const uint32_t middle = begin + (cut ? cut.below : count / 2);
        nodes_.resize(child + 2);
        nodes_[at] = node(extent.box, child, 0);
        Boxed* const next = boxed[(depth + 1) % 2].data();
        if (cut) {
            part_boxes(here, grid, cut, next + begin, next + middle);
        } else {
            halve_boxes(here, extent.centers);
            std::copy(here.begin(), here.end(), next + begin);
        }
        tasks.push_back({child + 1, depth + 1, middle, end});
        tasks.push_back({child, depth + 1, begin, middle});
    }
    for (const uint32_t place : order_) triangles_.push_back(source[place]);
    if (depth_ > BVH_STACK)
        throw Failure("the hierarchy has {} levels; rays can traverse at most {}", depth_, BVH_STACK);
}

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

}  // namespace lightwalk
