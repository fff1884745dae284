#include "05_shadow_maps/bvh_split.h"

#include <algorithm>
#include <limits>

namespace lightwalk {
namespace {

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

}  // namespace

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

void Bins::add(const Bins& other) {
    for (int axis = 0; axis < 3; ++axis)
        for (size_t bin = 0; bin < BinGrid::bins; ++bin) {
            box[axis][bin].add(other.box[axis][bin]);
            count[axis][bin] += other.count[axis][bin];
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

uint32_t Bins::below(const BinCut& cut) const {
    uint32_t below = 0;
    for (int bin = 0; bin < cut.bin; ++bin) below += count[cut.axis][size_t(bin)];
    return below;
}

BinCut best_cut(std::span<const Boxed> run, const BinGrid& grid) {
    if (run.size() <= few) return best_cut_of_few(run, grid);
    Bins bins;
    bins.add(run, grid);
    return bins.best_cut(grid);
}

// Branchless, since the comparison is unpredictable.
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

void halve_boxes(std::span<Boxed> run, const WideBox& centers) {
    const Four e = centers.upper - centers.lower;
    const int widest = e[0] >= e[1] && e[0] >= e[2] ? 0 : e[1] >= e[2] ? 1 : 2;
    std::nth_element(run.begin(), run.begin() + run.size() / 2, run.end(), [&](const Boxed& a, const Boxed& b) {
        return a.lower[widest] + a.upper[widest] < b.lower[widest] + b.upper[widest];
    });
}

}  // namespace lightwalk
