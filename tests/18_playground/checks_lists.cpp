// Checks of chapter 18: the list of steps, and the tree.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "18_playground/exercises.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE(
    "18.undo_stack",
    "Join first, then add up, then forget from the oldest on, but never the new one; look entries up in a map.") {
    struct Case {
        std::string name;
        std::vector<UndoSize> done;
        UndoSize step;
        bool has_undone;
        uint64_t most;
        Pushed right;
    };
    const std::vector<Case> cases{
        {"the first step", {}, {0, 10}, false, 100, {false, 0}},
        {"the first step, of a group", {}, {1, 10}, false, 100, {false, 0}},
        {"a step of another group", {{1, 10}}, {2, 10}, false, 100, {false, 0}},
        {"two steps without a group", {{0, 10}}, {0, 10}, false, 100, {false, 0}},
        {"the same group as the last step", {{1, 10}, {2, 10}}, {2, 10}, false, 100, {true, 0}},
        {"the same group, with another step in between", {{2, 10}, {1, 10}}, {2, 10}, false, 100, {false, 0}},
        {"the same group, after an undo", {{2, 10}}, {2, 10}, true, 100, {false, 0}},
        {"exactly as many bytes as there may be", {{0, 40}, {0, 50}}, {0, 10}, false, 100, {false, 0}},
        {"a byte more than there may be", {{0, 40}, {0, 50}}, {0, 11}, false, 100, {false, 1}},
        {"room for the new step alone", {{0, 40}, {0, 50}}, {0, 100}, false, 100, {false, 2}},
        {"a step that is larger than all there may be", {{0, 40}}, {0, 1000}, false, 100, {false, 1}},
        {"an old step of many bytes", {{0, 80}, {0, 10}}, {0, 20}, false, 60, {false, 1}},
        {"an old step of few bytes", {{0, 10}, {0, 80}}, {0, 20}, false, 35, {false, 2}},
        {"a step that joins and is too large", {{0, 40}, {0, 5}, {3, 50}}, {3, 60}, false, 100, {true, 2}},
        {"a step that joins, with room", {{0, 40}, {3, 50}}, {3, 11}, false, 100, {true, 1}},
        {"sums beyond 32 bits", {{0, 3000000000u}, {0, 3000000000u}}, {0, 1}, false, 6000000001u, {false, 0}},
        {"sums beyond 32 bits, with less room",
         {{0, 3000000000u}, {0, 3000000000u}},
         {0, 1},
         false,
         5000000000u,
         {false, 1}}};
    for (const Case& one : cases) {
        const std::string what = "push_step(" + one.name + ")";
        check.call(what, [&]() -> std::string {
            const Pushed got = push_step(one.done, one.step, one.has_undone, one.most);
            if (got.joins != one.right.joins)
                return fmt::format("{}: it {}", what,
                                   got.joins ? "joins the last step, and is one of its own"
                                             : "is a step of its own, and belongs to the last one");
            if (got.forgotten != one.right.forgotten)
                return fmt::format("{} forgets {} steps, expected {}", what, got.forgotten, one.right.forgotten);
            return "";
        });
        if (check.failed) return;
    }
    struct Join {
        std::string name;
        std::vector<Replaced> first, then, right;
    };
    Random random(5);
    std::vector<Join> joins{{"nothing and nothing", {}, {}, {}},
                            {"one entry and another", {{1, 5, 6}}, {{2, 7, 8}}, {{1, 5, 6}, {2, 7, 8}}},
                            {"one entry twice", {{1, 5, 6}}, {{1, 6, 7}}, {{1, 5, 7}}},
                            {"a new entry that is deleted", {{3, 0, 6}, {4, 1, 2}}, {{3, 6, 0}}, {{4, 1, 2}}},
                            {"a drag and back", {{3, 5, 6}}, {{3, 6, 5}, {4, 1, 2}}, {{4, 1, 2}}},
                            {"an entry that is deleted", {{3, 5, 6}}, {{3, 6, 0}}, {{3, 5, 0}}},
                            {"entries in another order",
                             {{9, 1, 2}, {8, 3, 4}},
                             {{8, 4, 5}, {7, 6, 7}, {9, 2, 3}},
                             {{9, 1, 3}, {8, 3, 5}, {7, 6, 7}}}};
    Join large{"100,000 entries", {}, {}, {}};
    for (uint32_t i = 0; i < 100000; ++i) {
        large.first.push_back({i, i + 1, i + 200000});
        large.then.push_back({99999 - i, 299999 - i, 400000 + i});
        large.right.push_back({i, i + 1, 499999 - i});
    }
    joins.push_back(large);
    // Any two steps, by the definition: entries of the one, the other and both, in orders of their own.
    for (int round = 0; round < 20; ++round) {
        Join any{fmt::format("any two steps, {}", round), {}, {}, {}};
        std::vector<uint32_t> entries(12);
        for (uint32_t i = 0; i < 12; ++i) entries[i] = i;
        const auto version = [&](double most) { return uint32_t(random.uniform(0, most)); };
        const auto fill = [&](std::vector<Replaced>& step) {
            for (size_t i = 11; i > 0; --i)
                std::swap(entries[i], entries[size_t(random.uniform(0, double(i) + 0.999))]);
            for (int i = 0; i < 7; ++i) {  // each has changed something
                const uint32_t before = version(3.9), after = (before + 1 + version(2.9)) % 4;
                step.push_back({entries[size_t(i)], before, after});
            }
        };
        fill(any.first);
        fill(any.then);
        for (Replaced one : any.first) {
            for (const Replaced& later : any.then)
                if (later.entry == one.entry) one.after = later.after;
            if (one.before != one.after) any.right.push_back(one);
        }
        for (const Replaced& later : any.then) {
            const bool is_new =
                std::ranges::none_of(any.first, [&](const Replaced& one) { return one.entry == later.entry; });
            if (is_new && later.before != later.after) any.right.push_back(later);
        }
        joins.push_back(any);
    }
    for (const Join& one : joins) {
        const std::string what = "join_steps(" + one.name + ")";
        check.call(what, [&]() -> std::string {
            const std::vector<Replaced> got = join_steps(one.first, one.then);
            for (size_t i = 0; i < std::min(got.size(), one.right.size()); ++i) {
                const Replaced &a = got[i], &b = one.right[i];
                if (a.entry != b.entry || a.before != b.before || a.after != b.after)
                    return fmt::format(
                        "{}: place {} is entry {} from version {} to {}, expected entry {} from {} to {}", what, i,
                        a.entry, a.before, a.after, b.entry, b.before, b.after);
            }
            if (got.size() != one.right.size())
                return fmt::format("{} gave {} entries, expected {}", what, got.size(), one.right.size());
            return "";
        });
        if (check.failed) return;
    }
    if (check.failed) return;
    std::vector<Replaced> first, then;
    check.expect_no_square("join_steps, entries", 2000, [&](size_t count) {
        first.clear();
        then.clear();
        for (uint32_t i = 0; i < count; ++i) {
            first.push_back({i, 1, 2});
            then.push_back({uint32_t(count) - 1 - i, 2, 3});
        }
        join_steps(first, then);
    });
}

namespace {

struct TreeCase {
    std::string name;
    std::vector<TreeNode> nodes;
    std::vector<uint32_t> selected;
    int32_t parent;
    std::optional<std::vector<uint32_t>> right;  // which nodes are moved
};

glm::mat4 somewhere(Random& random) {
    const glm::vec3 axis = random.direction();
    const float angle = float(random.uniform(-3, 3)), size = float(random.uniform(0.5, 2));
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1.0f), 5.0f * random.direction()), angle, axis),
                      {size, 2 * size, size});
}

}  // namespace

CHECK_EXERCISE("18.sort_tree_moves",
               "inverse(new parent's world) times the node's world; skip what has a selected node above it; refuse a "
               "parent below one.") {
    Random random(6);
    // 0 has 1 and 2; 1 has 3; 4 is alone; 5 has a parent, 6, that follows it.
    std::vector<TreeNode> nodes{{-1}, {0}, {0}, {1}, {-1}, {6}, {-1}};
    for (TreeNode& node : nodes) node.world = somewhere(random);
    std::vector<TreeNode> flat = nodes, turned_flat = nodes, tiny = nodes, mirrored = nodes;
    flat[4].world = glm::scale(glm::mat4(1.0f), {1, 0, 1});
    turned_flat[4].world = glm::scale(glm::rotate(glm::mat4(1.0f), 0.7f, {1, 2, 3}), {1, 1, 0});
    tiny[4].world = glm::scale(somewhere(random), glm::vec3(1e-4f));  // a determinant of 1e-12
    mirrored[4].world = glm::scale(somewhere(random), {-1, 1, 1});
    // 0 below 1, 1 below 2, 2 below 3.
    std::vector<TreeNode> rising{{1}, {2}, {3}, {-1}, {-1}};
    for (TreeNode& node : rising) node.world = somewhere(random);
    using Ids = std::vector<uint32_t>;
    std::vector<TreeCase> cases{{"nothing is selected", nodes, {}, 4, Ids{}},
                                {"one node to another", nodes, {2}, 4, Ids{2}},
                                {"two nodes, clicked in the other order", nodes, {4, 2}, 6, Ids{2, 4}},
                                {"a node clicked twice", nodes, {2, 2}, 4, Ids{2}},
                                {"into the world", nodes, {3}, -1, Ids{3}},
                                {"a node and its child", nodes, {1, 3}, 4, Ids{1}},
                                {"a node and its grandchild, the grandchild first", nodes, {3, 0}, 4, Ids{0}},
                                {"a child whose parent stands after it", nodes, {5, 6}, 4, Ids{6}},
                                {"a grandchild, with all above it after it", rising, {0, 2}, 4, Ids{2}},
                                {"the child of a grandchild, with all above it after it", rising, {0, 3}, 4, Ids{3}},
                                {"onto a grandchild that stands before it", rising, {3}, 0, std::nullopt},
                                {"onto itself", nodes, {2}, 2, std::nullopt},
                                {"onto its child", nodes, {0}, 1, std::nullopt},
                                {"onto its grandchild", nodes, {4, 0}, 3, std::nullopt},
                                {"onto a sibling", nodes, {1}, 2, Ids{1}},
                                {"onto the parent that it has", nodes, {1}, 0, Ids{1}},
                                {"onto a parent that scales to 0", flat, {2}, 4, std::nullopt},
                                {"onto a turned parent that scales to 0", turned_flat, {2}, 4, std::nullopt},
                                {"onto a parent that scales by 1e-4", tiny, {2}, 4, Ids{2}},
                                {"onto a parent that mirrors", mirrored, {2}, 4, Ids{2}}};
    TreeCase chain{"a chain of 100,000, every other node selected", {}, {}, -1, Ids{1}},
        wide{"100,000 side by side", {}, {}, 0, Ids{}};
    for (int i = 0; i < 100000; ++i) {
        chain.nodes.push_back({i - 1, glm::mat4(1.0f)});
        wide.nodes.push_back({-1, glm::mat4(1.0f)});
        if (i % 2) chain.selected.push_back(uint32_t(i));
        if (i) {
            wide.selected.push_back(uint32_t(i));
            wide.right->push_back(uint32_t(i));
        }
    }
    cases.push_back(chain);
    cases.push_back(wide);
    for (const TreeCase& one : cases) {
        const std::string what = "sort_tree_moves(" + one.name + ")";
        check.call(what, [&]() -> std::string {
            const auto got = sort_tree_moves(one.nodes, one.selected, one.parent);
            if (got.has_value() != one.right.has_value())
                return what +
                       (got ? " moved something: it has to refuse, with std::nullopt" : " refused, and it is possible");
            if (!got) return "";
            for (size_t i = 0; i < std::min(got->size(), one.right->size()); ++i)
                if ((*got)[i].node != (*one.right)[i])
                    return fmt::format("{}: place {} is node {}, expected node {}", what, i, (*got)[i].node,
                                       (*one.right)[i]);
            if (got->size() != one.right->size())
                return fmt::format("{} moves {} nodes, expected {}", what, got->size(), one.right->size());
            for (const TreeMove& move : *got) {
                const glm::dmat4 parent =
                    one.parent < 0 ? glm::dmat4(1.0) : glm::dmat4(one.nodes[size_t(one.parent)].world);
                const glm::dmat4 after = parent * glm::dmat4(move.local), before(one.nodes[move.node].world);
                for (int c = 0; c < 4; ++c)
                    for (int r = 0; r < 4; ++r)
                        if (!(std::fabs(after[c][r] - before[c][r]) < 1e-4))
                            return fmt::format(
                                "{}: node {} was at ({:.3f}, {:.3f}, {:.3f}) in the world and is at ({:.3f}, {:.3f}, "
                                "{:.3f})",
                                what, move.node, before[3].x, before[3].y, before[3].z, after[3].x, after[3].y,
                                after[3].z);
            }
            return "";
        });
        if (check.failed) return;
    }
    // A broom: a chain whose end has as many children as the chain has nodes, all of them selected, none above them.
    std::vector<TreeNode> broom;
    std::vector<uint32_t> bristles;
    check.expect_no_square("sort_tree_moves, a chain with children at its end", 2000, [&](size_t count) {
        broom.resize(count);
        bristles.clear();
        const size_t half = count / 2;
        for (size_t i = 0; i < count; ++i) {
            broom[i] = {i < half ? int32_t(i) - 1 : int32_t(half) - 1, glm::mat4(1.0f)};
            if (i >= half) bristles.push_back(uint32_t(i));
        }
        sort_tree_moves(broom, bristles, -1);
    });
}
