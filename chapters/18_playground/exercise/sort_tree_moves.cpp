// Exercise 18.sort_tree_moves: other parents for what is selected, and nothing moves in the picture.
// Starter: everything that is selected moves, its children twice, and jumps.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [sort_tree_moves]
// In the tree, the nodes `selected` (indices into `nodes`, in any order, some perhaps twice) are
// dragged onto the node `new_parent` (-1: out of all others, into the world). Returns which
// nodes get this parent, and the transform that each of them then has in the parent's space.
// The result is in the order of `nodes`, whatever the order in which they were clicked.
//
// 1. A node stays with a selected node above it (its parent, grandparent and so on). It moves
//    along with that node and is not in the result.
// 2. A node cannot hang below itself. Where `new_parent` is one of the selected nodes or hangs
//    below one, no node is moved. The result is then nothing (std::nullopt), which is not the
//    same as an empty list.
// 3. Each node stays where it is in the world: nodes[new_parent].world times `local` is its
//    world transform. Where the world matrix of the parent cannot be inverted (its determinant
//    is 0, as it scales something to 0), the result is nothing, too.
// 4. There are up to 100,000 nodes in a chain or side by side. Walking up from every selected
//    node to the root can take as many steps as the number of selected nodes times the length
//    of the chain. So store for the nodes on the way what was found.
//
// Tolerance: 1e-4 m for the world transform.
// [/sort_tree_moves]
std::optional<std::vector<TreeMove>> sort_tree_moves(std::span<const TreeNode> nodes,
                                                     std::span<const uint32_t> selected, int32_t new_parent) {
    (void)new_parent;
    std::vector<TreeMove> moves;
    for (const uint32_t node : selected) moves.push_back({node, nodes[node].world});
    return moves;
}

}  // namespace lightwalk::exercise
