#include "19_ambiance/spline.h"

#include <algorithm>
#include <limits>

#include "19_ambiance/exercises.h"

namespace lightwalk {

glm::dvec3 Curve::point(long i) const {
    const long last = long(points.size()) - 1;
    if (i < 0) return 2.0 * points[0] - points[size_t(std::min(-i, last))];
    if (i > last) return 2.0 * points[size_t(last)] - points[size_t(std::max(2 * last - i, 0L))];
    return points[size_t(i)];
}

// [at]
glm::dvec3 Curve::at(double time_s) const {
    if (points.empty()) return glm::dvec3(0.0);
    if (points.size() == 1 || !(time_s > times_s.front())) return points.front();
    if (time_s >= times_s.back()) return points.back();
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    const long i = after - times_s.begin() - 1;  // of the key before
    const double share = (time_s - times_s[size_t(i)]) / (times_s[size_t(i) + 1] - times_s[size_t(i)]);
    if (spline == Spline::linear) return glm::mix(point(i), point(i + 1), share);
    FourKeys keys{{point(i - 1), point(i), point(i + 1), point(i + 2)}, {0, 1, 2, 3}};
    if (spline == Spline::centripetal) {
        const std::vector<double> knots = centripetal_knots({keys.points.begin(), keys.points.end()});
        if (knots.size() == 4) std::copy(knots.begin(), knots.end(), keys.knots.begin());
        if (!(keys.knots[2] > keys.knots[1])) return point(i);  // it rests
    }
    return catmull_rom(keys, glm::mix(keys.knots[1], keys.knots[2], share));
}
// [/at]

std::vector<glm::dvec3> Curve::samples(int pieces) const {
    std::vector<glm::dvec3> all;
    if (points.empty()) return all;
    const int count = std::max(1, pieces * int(points.size() - 1));
    const double whole_s = times_s.back() - times_s.front();
    for (int i = 0; i <= count; ++i) all.push_back(at(times_s.front() + whole_s * i / count));
    return all;
}

glm::dvec3 Curve::at_even_speed(double time_s, const std::vector<glm::dvec3>& table) const {
    if (points.size() < 2) return at(time_s);
    const double whole_s = times_s.back() - times_s.front();
    const double share = std::clamp((time_s - times_s.front()) / whole_s, 0.0, 1.0);
    return at(times_s.front() + whole_s * arc_length(table, share));
}

double off_the_chord(const Curve& curve, int samples) {
    double most = 0;
    for (size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const glm::dvec3 a = curve.points[i], chord = curve.points[i + 1] - a;
        const double square = glm::dot(chord, chord);
        if (square <= 0) continue;
        for (int s = 0; s <= samples; ++s) {
            const double t = glm::mix(curve.times_s[i], curve.times_s[i + 1], double(s) / samples);
            const glm::dvec3 off = curve.at(t) - a;
            const double along = std::clamp(glm::dot(off, chord) / square, 0.0, 1.0);
            most = std::max(most, glm::length(off - along * chord) / std::sqrt(square));
        }
    }
    return most;
}

double speed_ratio(const Curve& curve, const std::vector<glm::dvec3>* table, int samples) {
    double slowest = std::numeric_limits<double>::max(), fastest = 0;
    const double begin = curve.times_s.front(), whole = curve.times_s.back() - begin;
    const auto place = [&](int i) {
        const double t = begin + whole * i / samples;
        return table ? curve.at_even_speed(t, *table) : curve.at(t);
    };
    for (int i = 0; i < samples; ++i) {
        const double step = glm::distance(place(i), place(i + 1));
        slowest = std::min(slowest, step);
        fastest = std::max(fastest, step);
    }
    return slowest > 0 ? fastest / slowest : std::numeric_limits<double>::infinity();
}

}  // namespace lightwalk
