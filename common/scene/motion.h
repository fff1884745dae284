// Motion of scene objects: spin and keyframed paths.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

struct Keyframe {
    float time_s = 0;
    glm::vec3 position{0.0f};
    glm::vec3 rotation_deg{0.0f};  ///< about x, then y, then z; may exceed 360
    glm::vec3 scale{1.0f};         ///< non-zero, with equal signs in all keyframes
    bool operator==(const Keyframe&) const = default;
};

struct Motion {
    float spin_deg_per_s = 0;  ///< about `axis`, in object space, before rotation_deg
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    std::vector<Keyframe> path;  ///< ascending times; replaces the object's own placement
    float period_s = 0;          ///< above 0: closed path, repeating this long after the first keyframe
    explicit operator bool() const { return spin_deg_per_s != 0.0f || !path.empty(); }
    bool operator==(const Motion&) const = default;
};

/// Catmull-Rom spline (E. Catmull and R. Rom, A Class of Local Interpolating Splines, 1974) for non-uniform time steps,
/// of scales in logarithms. Open paths are constant outside. `path` must not be empty.
Keyframe path_at(const Motion& motion, float time_s);

/// Rotation angle in radians, in (-2 pi, 2 pi).
float spin_at(const Motion& motion, float time_s);

}  // namespace lightwalk
