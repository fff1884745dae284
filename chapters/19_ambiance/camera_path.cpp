#include "19_ambiance/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

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

}  // namespace lightwalk
