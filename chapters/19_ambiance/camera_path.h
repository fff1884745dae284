// A camera that flies along keys.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "common/scene/camera.h"

namespace lightwalk {

/// Shape of a curve between its keys, cheapest first.
enum class Spline { linear, catmull_rom, centripetal };

/// A curve through keys at rising times, in seconds. Before the first and after the last it rests. One key: a point.
struct Curve {
    Spline spline = Spline::centripetal;
    std::vector<double> times_s;     ///< rising
    std::vector<glm::dvec3> points;  ///< as many
    bool smooth = false;             ///< the speed does not jump at a key; else knots pass evenly between two keys

    /// The place at a time. With the Catmull-Rom curves, beyond its ends a key mirrored in the end stands in for the
    /// missing neighbour, so that the curve leaves and arrives without a bend.
    glm::dvec3 at(double time_s) const;

    /// At an even speed: the place at the share of the whole length that `time_s` is of the whole time. `table` is
    /// samples() of this curve: 64 pieces keep the speed within 4% in the median of random paths
    /// (tests/19_ambiance/test_stability.cpp, [19.even_speed]).
    glm::dvec3 at_even_speed(double time_s, const std::vector<glm::dvec3>& table) const;

    /// Points at even spacing in time, `pieces` for each pair of keys, and the last one.
    std::vector<glm::dvec3> samples(int pieces) const;

  private:
    glm::dvec3 point(long i) const;     ///< mirrored beyond the ends
    std::vector<double> knots() const;  ///< the parameter at each key
};

/// The greatest distance of the curve from its keys' chords, in chords: of each pair, over the distance of its two keys.
double off_the_chord(const Curve& curve, int samples);

/// How much the velocity of what follows `place` changes at once at an inner key, at most: as a share of the larger speed, of
/// a millionth of the time to the keys before and behind. 0: it changes nowhere.
double velocity_jump(const std::vector<double>& times_s, const std::function<glm::dvec3(double)>& place);

/// Largest speed over smallest, between `samples` evenly spaced times; with a table at an even speed.
double speed_ratio(const Curve& curve, const std::vector<glm::dvec3>* table, int samples);

struct CameraKey {
    double time_s = 0;  ///< on its scene's clock
    glm::dvec3 position{0.0}, target{0.0}, up{0.0, 1.0, 0.0};
    double fov_deg = 0;  ///< 0: the scene's
};

/// How a camera moves.
struct PathKind {
    Spline spline = Spline::centripetal;
    int pieces =
        0;  ///< of the table that evens out the speed, for each pair of keys; 0: keys are passed at their times
    bool smooth_speed = false;  ///< of keys passed at their times: the speed does not jump there
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

}  // namespace lightwalk
