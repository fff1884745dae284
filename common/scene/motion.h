// How an object of a scene file moves: it turns, it follows a path, or both.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

/// Where the object is at a time, in its parent's space.
struct Keyframe {
    float time_s = 0;
    glm::vec3 position{0.0f};      ///< metres
    glm::vec3 rotation_deg{0.0f};  ///< about x, then y, then z; 360 is a whole turn, not none
    glm::vec3 scale{1.0f};         ///< not 0, and of one sign in all keyframes
    bool operator==(const Keyframe&) const = default;
};

struct Motion {
    float spin_deg_per_s = 0;          ///< about `axis`, before the object is rotated
    glm::vec3 axis{0.0f, 1.0f, 0.0f};  ///< any length above 0
    std::vector<Keyframe> path;        ///< in rising time; takes the place of the object's own placement
    float period_s = 0;  ///< above 0 the path is closed: so long after the first keyframe it is there again
    explicit operator bool() const { return spin_deg_per_s != 0.0f || !path.empty(); }
    bool operator==(const Motion&) const = default;
};

/// The path's placement at any time: a Catmull-Rom spline through the keyframes (E. Catmull and R. Rom, A Class of
/// Local Interpolating Splines, 1974), with the tangents of unequal steps in time; of scales, their logarithms. Before
/// the first keyframe of an open path it is there, after the last one there. The path is not empty.
Keyframe path_at(const Motion& motion, float time_s);

/// The angle in radians that the object has turned, in (-2 pi, 2 pi).
float spin_at(const Motion& motion, float time_s);

}  // namespace lightwalk
