#include "common/scene/motion.h"

#include <cmath>

namespace lightwalk {
namespace {

glm::vec3 log_scale(const Keyframe& key) { return glm::log(glm::abs(key.scale)); }

// Keyframe `i`: periodic on closed paths, clamped on open ones.
Keyframe key_at(const Motion& motion, int i) {
    const int count = static_cast<int>(motion.path.size());
    if (motion.period_s <= 0.0f) return motion.path[static_cast<size_t>(std::clamp(i, 0, count - 1))];
    const int round = i < 0 ? -1 : i / count;
    Keyframe key = motion.path[static_cast<size_t>(i - round * count)];
    key.time_s += static_cast<float>(round) * motion.period_s;
    return key;
}

}  // namespace

Keyframe path_at(const Motion& motion, float time_s) {
    const float start_s = motion.path.front().time_s;
    const bool closed = motion.period_s > 0.0f;
    double time = double(time_s) - start_s;
    if (closed) time = std::fmod(time, motion.period_s) + (time < 0 ? motion.period_s : 0.0);
    const float now_s = start_s + static_cast<float>(time);
    if (!closed && now_s <= start_s) return motion.path.front();
    if (!closed && now_s >= motion.path.back().time_s) return motion.path.back();

    int i = 0;
    while (i + 1 < static_cast<int>(motion.path.size()) && motion.path[static_cast<size_t>(i) + 1].time_s <= now_s) ++i;
    const Keyframe before = key_at(motion, i - 1), a = key_at(motion, i), b = key_at(motion, i + 1),
                   after = key_at(motion, i + 2);
    const float step_s = b.time_s - a.time_s, u = (now_s - a.time_s) / step_s, v = 1.0f - u;
    // Cubic Hermite spline; the tangent at a keyframe is the slope between its neighbours.
    const auto curve = [&](const auto& of) {
        const glm::vec3 slope_a = (of(b) - of(before)) / (b.time_s - before.time_s);
        const glm::vec3 slope_b = (of(after) - of(a)) / (after.time_s - a.time_s);
        return (1.0f + 2.0f * u) * v * v * of(a) + u * v * v * step_s * slope_a +  //
               (1.0f + 2.0f * v) * u * u * of(b) - v * u * u * step_s * slope_b;
    };
    return {.time_s = time_s,
            .position = curve([](const Keyframe& key) { return key.position; }),
            .rotation_deg = curve([](const Keyframe& key) { return key.rotation_deg; }),
            .scale = a.scale == b.scale && before.scale == a.scale && after.scale == b.scale
                         ? a.scale
                         : glm::sign(a.scale) * glm::exp(curve(log_scale))};
}

float spin_at(const Motion& motion, float time_s) {
    return static_cast<float>(glm::radians(std::fmod(double(motion.spin_deg_per_s) * time_s, 360.0)));
}

}  // namespace lightwalk
