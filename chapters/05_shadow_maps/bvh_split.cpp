#include "05_shadow_maps/bvh_split.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "05_shadow_maps/bvh_data.h"

namespace lightwalk {
namespace {

constexpr int bin_count = 16;

using Four = Boxed::Four;
using Numbers = int32_t __attribute__((vector_size(16)));

struct Box {
    Four lower, upper;
    static Box empty() { return {Four{} + 1e30f, Four{} - 1e30f}; }
    void add(const Four& from, const Four& to) {
        lower = from < lower ? from : lower;
        upper = to > upper ? to : upper;
    }
    // Half of the surface; in double precision, for the square of a planet's size is no float.
    double area() const {
        const Four e = upper - lower;
        const double x = e[0], y = e[1], z = e[2];
        return x * y + y * z + z * x;
    }
};

struct Bins {
    std::array<uint32_t, bin_count> count{};
    std::array<Box, bin_count> box;  ///< of bins that are not empty, and of no others
    void add(int at, const Boxed& b) {
        const auto bin = static_cast<size_t>(at);
        if (count[bin]++ == 0)
            box[bin] = {b.lower, b.upper};
        else
            box[bin].add(b.lower, b.upper);
    }
};

struct Cut {
    int axis = -1;  ///< -1: none
    int bin = 0;    ///< the first on the upper side
    double cost = INFINITY;
};

// The grid of bins over a run's centres.
struct Grid {
    Four origin, bins_per_m;
    bool has[3];  ///< an extent along this axis

    explicit Grid(const Box& centers) : origin(centers.lower), bins_per_m{} {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.upper[axis] - centers.lower[axis];
            const float scale = bin_count / extent;
            has[axis] = extent > 0 && std::isfinite(scale);
            if (has[axis]) bins_per_m[axis] = scale;
        }
    }
    Numbers bins_of(const Boxed& b) const {
        const auto at = __builtin_convertvector((b.center() - origin) * bins_per_m, Numbers);
        return at < bin_count - 1 ? at : Numbers{} + (bin_count - 1);
    }
    int bin_of(const Boxed& b, int axis) const {
        return std::min(static_cast<int>((b.center(axis) - origin[axis]) * bins_per_m[axis]), bin_count - 1);
    }
};

// The best cut along one axis, where it is cheaper than `best`. A border behind an empty bin cuts nothing else.
void try_axis(const Bins& bins, uint32_t total, int axis, Cut& best) {
    std::array<double, bin_count> upper_cost{};
    Box upper = Box::empty();
    uint32_t count = 0;
    for (size_t i = bin_count - 1; i > 0; --i) {
        if (bins.count[i] == 0) continue;
        upper.add(bins.box[i].lower, bins.box[i].upper);
        count += bins.count[i];
        upper_cost[i] = upper.area() * count;
    }
    Box lower = Box::empty();
    count = 0;
    for (size_t i = 0; i < bin_count; ++i) {
        if (bins.count[i] == 0) continue;
        lower.add(bins.box[i].lower, bins.box[i].upper);
        count += bins.count[i];
        if (count == total) return;
        size_t next = i + 1;
        while (bins.count[next] == 0) ++next;
        const double cost = lower.area() * count + upper_cost[next];
        if (cost < best.cost) best = {axis, static_cast<int>(next), cost};
    }
}

Cut best_cut(Run begin, Run end, const Grid& grid) {
    std::array<Bins, 3> bins;
    for (Run i = begin; i != end; ++i) {
        const Numbers at = grid.bins_of(*i);
        bins[0].add(at[0], *i);
        bins[1].add(at[1], *i);
        bins[2].add(at[2], *i);
    }
    Cut best;
    for (int axis = 0; axis < 3; ++axis)
        if (grid.has[axis]) try_axis(bins[axis], static_cast<uint32_t>(end - begin), axis, best);
    return best;
}

// How many levels a tree of halves needs for so many triangles.
uint32_t levels_of_halves(uint32_t count) { return std::bit_width((count + BVH_LEAF - 1) / BVH_LEAF - 1u); }

}  // namespace

Run split(Run begin, Run end, uint32_t levels) {
    Box box = Box::empty(), centers = Box::empty();
    for (Run i = begin; i != end; ++i) {
        box.add(i->lower, i->upper);
        centers.add(i->center(), i->center());
    }
    const auto count = static_cast<uint32_t>(end - begin);
    const Grid grid(centers);
    const Cut best = levels_of_halves(count) < levels ? best_cut(begin, end, grid) : Cut{};
    // Going down costs as much as one triangle.
    const bool helps = best.axis >= 0 && box.area() + best.cost < box.area() * count;
    if (count <= BVH_LEAF && !helps) return end;
    if (best.axis >= 0)
        return std::partition(begin, end, [&](const Boxed& b) { return grid.bin_of(b, best.axis) < best.bin; });
    const Four e = centers.upper - centers.lower;
    const int widest = e[0] >= e[1] && e[0] >= e[2] ? 0 : e[1] >= e[2] ? 1 : 2;
    const Run middle = begin + count / 2;
    std::nth_element(begin, middle, end,
                     [&](const Boxed& a, const Boxed& b) { return a.center(widest) < b.center(widest); });
    return middle;
}

}  // namespace lightwalk
