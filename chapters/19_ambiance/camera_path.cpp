#include "19_ambiance/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "19_ambiance/exercises.h"

namespace lightwalk {

namespace {

constexpr int table_pieces = 64;             // between two keys
constexpr double nearly_parallel = 0.17365;  // sin 10 degrees: below, a key's up says nothing about a roll

glm::dvec3 any_at_right_angle(glm::dvec3 forward) {
    const glm::dvec3 axis = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    return glm::normalize(axis - glm::dot(axis, forward) * forward);
}

// About `forward`, counter-clockwise seen against it, from `from` to `to`; both at right angles to it.
double turn_between(glm::dvec3 forward, glm::dvec3 from, glm::dvec3 to) {
    return std::atan2(glm::dot(glm::cross(from, to), forward), glm::dot(from, to));
}

}  // namespace

CameraPath::CameraPath(std::vector<CameraKey> keys, PathKind kind) : keys_(std::move(keys)) {
    for (const CameraKey& key : keys_) {
        for (Curve* curve : {&position_, &target_, &angle_}) curve->times_s.push_back(key.time_s);
        position_.points.push_back(key.position);
        target_.points.push_back(key.target);
        angle_.points.emplace_back(key.fov_deg, 0.0, 0.0);
    }
    choose(kind);
}

void CameraPath::choose(PathKind kind) {
    position_.spline = target_.spline = kind.spline;
    position_.smooth = target_.smooth = kind.smooth_speed && kind.pieces == 0;
    angle_.spline = Spline::linear;
    even_ = kind.pieces > 0 ? position_.samples(kind.pieces) : std::vector<glm::dvec3>();
    if (!keys_.empty()) tabulate();
}

glm::dvec3 CameraPath::eye(double time_s) const {
    return even_.empty() ? position_.at(time_s) : position_.at_even_speed(time_s, even_);
}

glm::dvec3 CameraPath::forward(double time_s) const {
    const glm::dvec3 from = eye(time_s), away = target_.at(time_s) - from;
    const double length = glm::length(away);
    // The eye in its own target looks nowhere: it looks as it would a moment before.
    if (length > 1e-9 * (1 + glm::length(from))) return away / length;
    const glm::dvec3 before = target_.at(time_s - 1e-3) - eye(time_s - 1e-3);
    return glm::length(before) > 0 ? glm::normalize(before) : glm::dvec3(0, 0, -1);
}

// [tabulate]
// Carries an up vector from the first key to the last, by the shortest rotation from each view to the next, and
// stores the roll of each key: the angle from the carried up to the key's own. A key with an up nearly parallel to
// its view has no roll. Of angles that differ by whole turns, the one nearest to the previous key's roll is stored.
void CameraPath::tabulate() {
    forwards_.clear();
    carried_.clear();
    roll_times_.clear();
    rolls_.clear();
    const double begin = keys_.front().time_s, whole = keys_.back().time_s - begin;
    const int count = std::max(1, table_pieces * int(keys_.size() - 1));
    for (int i = 0; i <= count; ++i) {
        const glm::dvec3 view = forward(begin + whole * i / count);
        carried_.push_back(i == 0 ? any_at_right_angle(view)
                                  : up_without_roll(carried_.back(), forwards_.back(), view));
        forwards_.push_back(view);
    }
    for (const CameraKey& key : keys_) {
        const glm::dvec3 view = forward(key.time_s);
        const glm::dvec3 wanted = glm::normalize(key.up), across = wanted - glm::dot(wanted, view) * view;
        if (glm::length(across) < nearly_parallel) continue;
        const auto i = static_cast<size_t>(whole > 0 ? std::floor((key.time_s - begin) / whole * count) : 0);
        const glm::dvec3 carried = up_without_roll(carried_[i], forwards_[i], view);
        double roll = turn_between(view, carried, glm::normalize(across));
        if (!rolls_.empty()) roll -= glm::two_pi<double>() * std::round((roll - rolls_.back()) / glm::two_pi<double>());
        roll_times_.push_back(key.time_s);
        rolls_.push_back(roll);
    }
}
// [/tabulate]

glm::dvec3 CameraPath::up(double time_s) const {
    const double begin = keys_.front().time_s, whole = keys_.back().time_s - begin;
    const double place_in =
        whole > 0 ? std::clamp((time_s - begin) / whole, 0.0, 1.0) * double(carried_.size() - 1) : 0;
    const auto i = static_cast<size_t>(place_in);
    const glm::dvec3 view = forward(time_s), carried = up_without_roll(carried_[i], forwards_[i], view);
    Curve roll{.spline = Spline::linear, .times_s = roll_times_, .points = {}};
    for (const double angle : rolls_) roll.points.emplace_back(angle, 0.0, 0.0);
    const double turn = roll.at(time_s).x;
    return std::cos(turn) * carried + std::sin(turn) * glm::cross(view, carried);
}

Camera CameraPath::at(double time_s, const Camera& camera) const {
    if (keys_.empty()) return camera;
    Camera moved = camera;
    const glm::dvec3 from = eye(time_s), view = forward(time_s);
    moved.position = glm::vec3(from);
    const double away = std::max(glm::distance(from, target_.at(time_s)), 1e-3 * (1 + glm::length(from)));
    moved.target = glm::vec3(from + away * view);
    moved.up = glm::vec3(up(time_s));
    if (const double fov = angle_.at(time_s).x; fov > 0) moved.fov_y_rad = static_cast<float>(glm::radians(fov));
    return moved;
}

glm::dvec3 Curve::point(long i) const {
    const long last = long(points.size()) - 1;
    if (i < 0) return 2.0 * points[0] - points[size_t(std::min(-i, last))];
    if (i > last) return 2.0 * points[size_t(last)] - points[size_t(std::max(2 * last - i, 0L))];
    return points[size_t(i)];
}

std::vector<double> Curve::knots() const {
    if (spline == Spline::centripetal) return centripetal_knots(points);
    std::vector<double> all(points.size());
    for (size_t i = 1; i < points.size(); ++i)
        all[i] = all[i - 1] + (spline == Spline::linear ? glm::distance(points[i - 1], points[i]) : 1);
    return all;
}

glm::dvec3 Curve::at(double time_s) const {
    if (points.empty()) return glm::dvec3(0.0);
    if (points.size() == 1 || !(time_s > times_s.front())) return points.front();
    if (time_s >= times_s.back()) return points.back();
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    const long i = after - times_s.begin() - 1;  // of the key before
    double share = (time_s - times_s[size_t(i)]) / (times_s[size_t(i) + 1] - times_s[size_t(i)]);
    if (smooth) {
        const std::vector<double> all = knots();
        if (all.size() == points.size() && all[size_t(i) + 1] > all[size_t(i)])
            share = (knot_at(times_s, all, time_s) - all[size_t(i)]) / (all[size_t(i) + 1] - all[size_t(i)]);
    }
    if (spline == Spline::linear) return glm::mix(point(i), point(i + 1), share);
    FourKeys keys{{point(i - 1), point(i), point(i + 1), point(i + 2)}, {0, 1, 2, 3}};
    if (spline == Spline::centripetal) {
        const std::vector<double> knots = centripetal_knots({keys.points.begin(), keys.points.end()});
        if (knots.size() == 4) std::copy(knots.begin(), knots.end(), keys.knots.begin());
        if (!(keys.knots[2] > keys.knots[1])) return point(i);  // it rests
    }
    return catmull_rom(keys, glm::mix(keys.knots[1], keys.knots[2], share));
}

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

double velocity_jump(const std::vector<double>& times_s, const std::function<glm::dvec3(double)>& place) {
    double most = 0;
    for (size_t i = 1; i + 1 < times_s.size(); ++i) {
        const double before_s = 1e-6 * (times_s[i] - times_s[i - 1]), behind_s = 1e-6 * (times_s[i + 1] - times_s[i]);
        const glm::dvec3 at = place(times_s[i]), before = (at - place(times_s[i] - before_s)) / before_s,
                         behind = (place(times_s[i] + behind_s) - at) / behind_s;
        const double faster = std::max(glm::length(before), glm::length(behind));
        if (faster > 0) most = std::max(most, glm::distance(before, behind) / faster);
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
