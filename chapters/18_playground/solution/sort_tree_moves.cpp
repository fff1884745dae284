#include "18_playground/exercises.h"

namespace lightwalk::solution {
namespace {

// For each node, whether it or an ancestor is selected: walks up to a known node, then fills in the results on the
// way back.
std::vector<char> covered(std::span<const TreeNode> nodes, const std::vector<char>& is_selected) {
    constexpr char unknown = 2;
    std::vector<char> known(nodes.size(), unknown);
    std::vector<size_t> way;
    for (size_t i = 0; i < nodes.size(); ++i) {
        size_t at = i;
        char result = unknown;
        while (result == unknown) {
            if (known[at] != unknown) {
                result = known[at];
            } else if (way.push_back(at); is_selected[at]) {
                result = 1;
            } else if (nodes[at].parent < 0) {
                result = 0;
            } else {
                at = static_cast<size_t>(nodes[at].parent);
            }
        }
        for (; !way.empty(); way.pop_back()) known[way.back()] = result;
    }
    return known;
}

}  // namespace

std::optional<std::vector<TreeMove>> sort_tree_moves(std::span<const TreeNode> nodes,
                                                     std::span<const uint32_t> selected, int32_t new_parent) {
    std::vector<char> is_selected(nodes.size(), 0);
    for (const uint32_t node : selected) is_selected[node] = 1;
    const std::vector<char> below = covered(nodes, is_selected);
    glm::dmat4 to_parent(1.0);
    if (new_parent >= 0) {
        const glm::dmat4 world(nodes[static_cast<size_t>(new_parent)].world);
        if (below[static_cast<size_t>(new_parent)] || glm::determinant(world) == 0.0) return std::nullopt;
        to_parent = glm::inverse(world);
    }
    std::vector<TreeMove> moves;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const int32_t parent = nodes[i].parent;
        if (!is_selected[i] || (parent >= 0 && below[static_cast<size_t>(parent)])) continue;
        moves.push_back({static_cast<uint32_t>(i), glm::mat4(to_parent * glm::dmat4(nodes[i].world))});
    }
    return moves;
}

}  // namespace lightwalk::solution
