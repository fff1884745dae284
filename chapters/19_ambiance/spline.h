// Curves through keys: linear, uniform and centripetal Catmull-Rom, by parameter or by arc length.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk {

// [spline]
/// Shape of a curve between its keys, cheapest first.
enum class Spline { linear, catmull_rom, centripetal };

/// A curve through keys at rising times, in seconds. Before the first and after the last it rests. One key: a point.
struct Curve {
    Spline spline = Spline::centripetal;
    std::vector<double> times_s;     ///< rising
    std::vector<glm::dvec3> points;  ///< as many

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
    glm::dvec3 point(long i) const;  ///< mirrored beyond the ends
};
// [/spline]

/// The greatest distance of the curve from its keys' chords, in chords: of each pair, over the distance of its two keys.
double off_the_chord(const Curve& curve, int samples);

/// Largest speed over smallest, between `samples` evenly spaced times; with a table at an even speed.
double speed_ratio(const Curve& curve, const std::vector<glm::dvec3>* table, int samples);

}  // namespace lightwalk
