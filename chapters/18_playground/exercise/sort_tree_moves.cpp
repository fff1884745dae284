// Exercise 18.sort_tree_moves: other parents for what is selected, and nothing moves in the picture.
// As it stands everything that is selected moves, its children twice, and jumps.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [sort_tree_moves]
// In the tree, the nodes `selected` (places in `nodes`, in any order, some perhaps twice) are dragged onto the node
// `new_parent` (-1: out of all others, into the world). Returns which nodes get this parent, and the transform that each then
// has in its parent's space. The order of the result is that of `nodes`, whatever the order in which they were clicked.
//
// 1. A node whose parent, grandparent and so on is selected too stays with it: it is moved along, and is not in the result.
// 2. A node cannot hang below itself. Where `new_parent` is one of the selected nodes or hangs below one, nothing at all is
//    moved: the result is nothing (std::nullopt), which is not the same as an empty list.
// 3. Each node stays where it is in the world: nodes[new_parent].world times `local` is its world transform. Where the
//    parent's world matrix cannot be inverted (it scales something to 0: its determinant is 0), the result is nothing, too.
// 4. There are up to 100,000 nodes in a chain or side by side. A walk up from each selected node costs the product of
//    both: remember what is known of the nodes on the way.
// [/sort_tree_moves]
std::optional<std::vector<TreeMove>> sort_tree_moves(std::span<const TreeNode> nodes,
                                                     std::span<const uint32_t> selected, int32_t new_parent) {
    (void)new_parent;
    std::vector<TreeMove> moves;
    for (const uint32_t node : selected) moves.push_back({node, nodes[node].world});
    return moves;
}

}  // namespace lightwalk::exercise
