// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/base/exercise.h"
#include "common/scene/pick.h"

namespace lightwalk {

/// Specification: exercise/pick_ray.cpp.
EXERCISE("18.pick_ray", PickRay, pick_ray, const glm::mat4& clip_to_world, glm::vec2 cursor_px, glm::uvec2 size);

/// Specification: exercise/drag_on_axis.cpp.
EXERCISE("18.drag_on_axis", float, drag_on_axis, const PickRay& ray, glm::vec3 pivot, glm::vec3 axis);

// [turned_types]
/// Where an object is and how it is turned; `orientation` has unit length.
struct Pose {
    glm::vec3 position{0.0f};
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
};
// [/turned_types]

/// Specification: exercise/rotate_about_pivot.cpp.
EXERCISE("18.rotate_about_pivot", Pose, rotate_about_pivot, const Pose& pose, glm::vec3 pivot, glm::vec3 axis,
         float angle_rad);

// [undo_types]
/// An entry of the scene as a step found it and as the step left it: numbers of versions, 0 where there is none.
struct Replaced {
    uint32_t entry = 0;
    uint32_t before = 0, after = 0;
};

/// A step that can be undone. Steps of one gesture have the same `group`; 0 stands for itself alone.
struct UndoSize {
    uint64_t group = 0;
    uint64_t bytes = 0;
};

/// Decision on a new step.
struct Pushed {
    bool joins = false;      ///< it becomes a part of the last one
    uint32_t forgotten = 0;  ///< how many of the oldest steps go
};
// [/undo_types]

/// Specification: exercise/undo_stack.cpp.
EXERCISE("18.undo_stack", Pushed, push_step, std::span<const UndoSize> done, const UndoSize& step, bool has_undone,
         uint64_t most_bytes);
EXERCISE("18.undo_stack", std::vector<Replaced>, join_steps, std::span<const Replaced> first,
         std::span<const Replaced> then);

// [tree_types]
/// A node of the scene's tree. Parents need not stand before their children.
struct TreeNode {
    int32_t parent = -1;    ///< its place in the list; -1: none
    glm::mat4 world{1.0f};  ///< from its own space to the world
};

struct TreeMove {
    uint32_t node = 0;
    glm::mat4 local{1.0f};  ///< from its own space to that of its new parent
};
// [/tree_types]

/// Specification: exercise/sort_tree_moves.cpp.
EXERCISE("18.sort_tree_moves", std::optional<std::vector<TreeMove>>, sort_tree_moves, std::span<const TreeNode> nodes,
         std::span<const uint32_t> selected, int32_t new_parent);

}  // namespace lightwalk
