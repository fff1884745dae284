// Places of entries: matrices of the scene file's numbers, and numbers of matrices.
#pragma once
#include "18_playground/document.h"

namespace lightwalk {

/// Numbers of a scene file: applied as scale, then rotation, then position.
struct Placement {
    glm::vec3 position{0.0f}, rotation_deg{0.0f}, scale{1.0f};
    bool operator==(const Placement&) const = default;
};

/// Smallest size of a scale: 0 has no inverse and the scene file refuses it.
inline constexpr float least_scale = 1e-6f;

/// Rotation about x, then y, then z, in degrees, and back. Of the two triples that mean one rotation, and of the many
/// where y is 90°, the result is the one closest to `near_deg`.
glm::dquat rotation_of(const glm::vec3& rotation_deg);
glm::vec3 rotation_deg_of(const glm::dquat& rotation, const glm::vec3& near_deg = glm::vec3(0.0f));

/// `exact`: false where the matrix shears, which no three numbers say; the result is then the nearest without it.
Placement placement_of(const glm::mat4& matrix, const glm::vec3& near_deg, bool* exact = nullptr);
Placement placement_of(const SceneObject& object);
glm::mat4 matrix_of(const Placement& placement);

/// From the entry's space to the world. Of a light its position alone.
glm::mat4 world_of(const Document& document, EntryId id);

}  // namespace lightwalk
