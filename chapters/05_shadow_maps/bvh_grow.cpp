#include "05_shadow_maps/bvh_grow.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <thread>

#include "01_obj/threads.h"
#include "05_shadow_maps/bvh.h"
#include "05_shadow_maps/bvh_split.h"

namespace lightwalk {
namespace {

using Four = WideBox::Four;

// Threshold above which all threads split a run together, in jobs of this size.
constexpr uint32_t large = 2048;

struct Grower {
    // Upper node, or root of a branch that grows in one thread.
    struct Branch {
        uint32_t begin, end, depth;
        Extent extent{};
        uint32_t child = 0;               // first of two adjacent children; 0: grows in one thread
        uint32_t nodes = 0, deepest = 0;  // size and depth of the finished branch
        uint32_t slot = 0, below = 0;     // final indices of the node and of the nodes below
        uint32_t count() const { return end - begin; }
    };
    // Part of a large branch, for one thread.
    struct Piece {
        size_t branch;
        uint32_t begin, end;
        uint32_t lower = 0, upper = 0;  // destinations of both sides
        Extent extents[2]{};
    };
    // Branches of one depth, and the pieces of large ones.
    struct Level {
        size_t first, count;
        uint32_t depth;
        std::vector<BinGrid> grids{};
        std::vector<BinCut> cuts{};
        std::vector<Piece> pieces{};
        std::vector<uint32_t> first_piece{};
        std::span<Piece> pieces_of(size_t branch) {
            return std::span(pieces).subspan(first_piece[branch], first_piece[branch + 1] - first_piece[branch]);
        }
    };

    const std::vector<RayTriangle>& source;
    unsigned threads;
    GrownBvh grown{};
    std::vector<Boxed> boxed[2]{};              // runs at even and odd depths; each split copies from one to the other
    std::vector<std::vector<BvhNode>> growing;  // per thread
    std::vector<Branch> branches{};
    Four margin{};

    Grower(const std::vector<RayTriangle>& triangles, unsigned most)
        : source(triangles),
          threads(static_cast<unsigned>(std::min<size_t>(most, (triangles.size() + large - 1) / large))),
          growing(threads) {}

    uint32_t total() const { return static_cast<uint32_t>(source.size()); }
    std::span<Boxed> run(uint32_t depth, uint32_t begin, uint32_t end) {
        return {boxed[depth % 2].data() + begin, end - begin};
    }
    bool enclose();
    void split_large();
    void cut_in_pieces(Level& level) const;
    void find_cuts(Level& level);
    void copy_sides(Level& level);
    void add_children(Level& level);
    void grow_below(Branch& branch, std::vector<BvhNode>& to);
    // Finished branches store their nodes over their boxes, which need more space.
    void* kept(const Branch& branch, uint32_t node) {
        static_assert(sizeof(BvhNode) == sizeof(Boxed));
        return &boxed[node % 2][branch.begin + node / 2];
    }
    void place();
    void copy_below(const Branch& branch);
    BvhNode node(const WideBox& box, uint32_t first, uint32_t count) const {
        const Four lower = box.lower - margin, upper = box.upper + margin;
        return {{lower[0], lower[1], lower[2]}, first, {upper[0], upper[1], upper[2]}, count};
    }
};

// Boxes of all triangles, and the root; false if a corner is not finite or too far.
bool Grower::enclose() {
    for (std::vector<Boxed>& b : boxed) b.resize(total());
    std::vector<Extent> extents((total() + large - 1) / large);
    std::atomic<bool> is_finite = true;
    on_threads(threads, extents.size(), [&](unsigned, size_t job) {
        const auto begin = static_cast<uint32_t>(job) * large, end = std::min(begin + large, total());
        Extent extent;
        auto outside = Four{} != Four{};
        for (uint32_t i = begin; i < end; ++i) {
            const Four a = wide_corner(source[i], 0), b = wide_corner(source[i], 1), c = wide_corner(source[i], 2);
            Boxed& box = boxed[0][i];
            box = {};
            box.add(a, a);
            box.add(b, b);
            box.add(c, c);
            box.set_place(i);
            extent.add(box);
            for (const Four& p : {a, b, c}) outside |= ~((p <= Bvh::farthest_m) & (p >= -Bvh::farthest_m));
        }
        extents[job] = extent;
        if (outside[0] || outside[1] || outside[2]) is_finite = false;
    });
    Branch& root = branches.emplace_back(Branch{0, total(), 0});
    for (const Extent& e : extents) root.extent.add(e);
    float farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::fabs(root.extent.box.lower[axis]), std::fabs(root.extent.box.upper[axis])});
    margin = Four{} + box_margin(farthest);
    return is_finite;
}

void Grower::split_large() {
    for (size_t first = 0; first < branches.size();) {
        Level level{.first = first, .count = branches.size() - first, .depth = branches[first].depth};
        first = branches.size();
        cut_in_pieces(level);
        find_cuts(level);
        copy_sides(level);
        add_children(level);
    }
}

void Grower::cut_in_pieces(Level& level) const {
    for (const Branch& b : std::span(branches).subspan(level.first, level.count)) {
        level.grids.emplace_back(b.extent.centers);
        level.first_piece.push_back(static_cast<uint32_t>(level.pieces.size()));
        if (b.count() > large && levels_of_halves(b.count()) < BVH_STACK - b.depth)
            for (uint32_t at = b.begin; at < b.end; at += large)
                level.pieces.push_back({level.grids.size() - 1, at, std::min(at + large, b.end)});
    }
    level.first_piece.push_back(static_cast<uint32_t>(level.pieces.size()));
}

// Fills the pieces' bins; the last piece of a branch merges them.
void Grower::find_cuts(Level& level) {
    std::vector<Bins> bins(level.pieces.size());
    std::vector<std::atomic<size_t>> done(level.count);
    level.cuts.resize(level.count);
    on_threads(threads, level.pieces.size(), [&](unsigned, size_t job) {
        const Piece& own = level.pieces[job];
        const BinGrid& grid = level.grids[own.branch];
        bins[job].add(run(level.depth, own.begin, own.end), grid);
        const std::span<Piece> pieces = level.pieces_of(own.branch);
        if (++done[own.branch] < pieces.size()) return;
        const std::span<const Bins> all{&bins[level.first_piece[own.branch]], pieces.size()};
        Bins sum;
        for (const Bins& b : all) sum.add(b);
        const BinCut cut = level.cuts[own.branch] = sum.best_cut(grid);
        if (!cut) return;
        uint32_t lower = pieces.front().begin, upper = lower + cut.below;
        for (size_t i = 0; i < pieces.size(); ++i) {
            const uint32_t below = all[i].below(cut);
            pieces[i].lower = lower;
            pieces[i].upper = upper;
            lower += below;
            upper += pieces[i].end - pieces[i].begin - below;
        }
    });
}

void Grower::copy_sides(Level& level) {
    on_threads(threads, level.pieces.size(), [&](unsigned, size_t job) {
        Piece& piece = level.pieces[job];
        const BinCut& cut = level.cuts[piece.branch];
        if (!cut) return;
        Boxed* const to = boxed[(level.depth + 1) % 2].data();
        const std::span<const Boxed> from = run(level.depth, piece.begin, piece.end);
        const size_t below = part_boxes(from, level.grids[piece.branch], cut, to + piece.lower, to + piece.upper);
        piece.extents[0] = extent_of({to + piece.lower, below});
        piece.extents[1] = extent_of({to + piece.upper, from.size() - below});
    });
}

void Grower::add_children(Level& level) {
    for (size_t i = 0; i < level.count; ++i) {
        if (!level.cuts[i]) continue;
        Branch& above = branches[level.first + i];
        const uint32_t middle = above.begin + level.cuts[i].below;
        Branch lower{above.begin, middle, level.depth + 1}, upper{middle, above.end, level.depth + 1};
        for (const Piece& piece : level.pieces_of(i)) {
            lower.extent.add(piece.extents[0]);
            upper.extent.add(piece.extents[1]);
        }
        above.child = static_cast<uint32_t>(branches.size());
        branches.push_back(lower);
        branches.push_back(upper);
    }
}

// Build in one thread. `to`: memory for nodes.
void Grower::grow_below(Branch& branch, std::vector<BvhNode>& to) {
    struct Task {
        uint32_t node, depth, begin, end;
    };
    to.resize(std::max<size_t>(to.size(), 2 * branch.count()));
    std::vector<Task> tasks{{0, branch.depth, branch.begin, branch.end}};
    branch.nodes = 1;
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto [at, depth, begin, end] = task;
        const uint32_t count = end - begin;
        const std::span<Boxed> here = run(depth, begin, end);
        const Extent extent = extent_of(here);
        const BinGrid grid(extent.centers);
        const BinCut cut = count > 1 && levels_of_halves(count) < BVH_STACK - depth ? best_cut(here, grid) : BinCut{};
        const double area = extent.box.area();
        // A traversal step costs as much as one triangle test.
        if (count <= BVH_LEAF && !(cut && area + cut.cost < area * count)) {
            to[at] = node(extent.box, begin, count);
            for (uint32_t i = 0; i < count; ++i) grown.order[begin + i] = here[i].place();
            branch.deepest = std::max(branch.deepest, depth);
            continue;
        }
        const uint32_t child = branch.nodes, middle = begin + (cut ? cut.below : count / 2);
        branch.nodes += 2;
        to[at] = node(extent.box, child, 0);
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
    for (uint32_t i = branch.begin; i < branch.end; ++i) grown.triangles[i] = source[grown.order[i]];
    for (uint32_t i = 0; i < branch.nodes; ++i) std::memcpy(kept(branch, i), &to[i], sizeof(BvhNode));
}

// Order: both children, then the first one's subtree, then the second one's.
void Grower::place() {
    uint32_t next = 1;
    std::vector<size_t> waiting{0};
    while (!waiting.empty()) {
        Branch& branch = branches[waiting.back()];
        waiting.pop_back();
        branch.below = next;
        grown.depth = std::max(grown.depth, branch.deepest);
        if (branch.child == 0) {
            next += branch.nodes - 1;
            continue;
        }
        next += 2;
        for (const uint32_t i : {0u, 1u}) branches[branch.child + i].slot = branch.below + i;
        waiting.push_back(branch.child + 1);
        waiting.push_back(branch.child);
    }
    grown.nodes.resize(next);
}

void Grower::copy_below(const Branch& branch) {
    BvhNode* const to = grown.nodes.data();
    if (branch.child != 0) {
        to[branch.slot] = node(branch.extent.box, branch.below, 0);
        return;
    }
    for (uint32_t i = 0; i < branch.nodes; ++i) {
        BvhNode one;
        std::memcpy(&one, kept(branch, i), sizeof one);
        if (one.count == 0) one.first += branch.below - 1;
        to[i == 0 ? branch.slot : branch.below + i - 1] = one;
    }
}

}  // namespace

GrownBvh grow_bvh(const std::vector<RayTriangle>& triangles, unsigned threads) {
    if (threads == 0) threads = std::max(std::thread::hardware_concurrency(), 1u);
    Grower grower(triangles, threads);
    GrownBvh& grown = grower.grown;
    grown.is_finite = grower.enclose();
    if (!grown.is_finite) return std::move(grown);
    grower.split_large();
    grown.order.resize(triangles.size());
    grown.triangles.resize(triangles.size());
    on_threads(grower.threads, grower.branches.size(), [&](unsigned thread, size_t i) {
        if (grower.branches[i].child == 0) grower.grow_below(grower.branches[i], grower.growing[thread]);
    });
    grower.place();
    on_threads(grower.threads, grower.branches.size(),
               [&](unsigned, size_t i) { grower.copy_below(grower.branches[i]); });
    return std::move(grown);
}

}  // namespace lightwalk
