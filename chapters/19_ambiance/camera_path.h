// A camera that flies along keys.
#pragma once
#include "19_ambiance/spline.h"
#include "common/scene/camera.h"

namespace lightwalk {

struct CameraKey {
    double time_s = 0;  ///< on its scene's clock
    glm::dvec3 position{0.0}, target{0.0}, up{0.0, 1.0, 0.0};
    double fov_deg = 0;  ///< 0: the scene's
};

// [camera_path]
/// How a camera moves.
struct PathKind {
    Spline spline = Spline::centripetal;
    int pieces =
        0;  ///< of the table that evens out the speed, for each pair of keys; 0: keys are passed at their times
    bool operator==(const PathKind&) const = default;
};

/// Position and target on a spline each, and an up that neither rolls where the view passes it nor vanishes between
/// keys with opposite ups. Everything is a function of time: the rotation of up, which depends on the path so far, is
/// tabulated from the first key on.
class CameraPath {
  public:
    CameraPath() = default;
    CameraPath(std::vector<CameraKey> keys, PathKind kind);

    /// `camera` with its place, direction, up and angle at a time.
    Camera at(double time_s, const Camera& camera) const;

    bool empty() const { return keys_.empty(); }
    const std::vector<CameraKey>& keys() const { return keys_; }
    const Curve& positions() const { return position_; }
    void choose(PathKind kind);
    glm::dvec3 eye(double time_s) const;  ///< where it is; there must be a key

  private:
    glm::dvec3 forward(double time_s) const;
    glm::dvec3 up(double time_s) const;
    void tabulate();
    std::vector<CameraKey> keys_;
    Curve position_, target_, angle_;
    std::vector<glm::dvec3> even_;                ///< the table of an even speed; empty: by the keys' times
    std::vector<glm::dvec3> forwards_, carried_;  ///< at evenly spaced times: the view, and an up that never rolls
    std::vector<double> roll_times_, rolls_;      ///< the keys' additional roll, in radians
};
// [/camera_path]

}  // namespace lightwalk
