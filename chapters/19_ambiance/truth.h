// Truth of chapter 19's exercises, in double precision, by methods other than the solutions'.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "19_ambiance/exercises.h"

namespace lightwalk::truth {

/// As a cubic Hermite curve: tangents at p1 and p2 from the parabolas through three keys each.
inline glm::dvec3 catmull_rom(const FourKeys& keys, double t) {
    const auto& [p, k] = keys;
    const double d0 = k[1] - k[0], d1 = k[2] - k[1], d2 = k[3] - k[2];
    if (d1 <= 0) return p[1];
    const auto slope = [&](size_t i, double d) { return d > 0 ? (p[i + 1] - p[i]) / d : glm::dvec3(0.0); };
    const glm::dvec3 s0 = slope(0, d0), s1 = slope(1, d1), s2 = slope(2, d2);
    // Where a key is doubled, the tangent there is 0.
    const glm::dvec3 m1 = (s0 * d1 + s1 * d0) / (d0 + d1);
    const glm::dvec3 m2 = (s1 * d2 + s2 * d1) / (d1 + d2);
    const double u = (t - k[1]) / d1, u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * p[1] + (u3 - 2 * u2 + u) * d1 * m1 + (3 * u2 - 2 * u3) * p[2] + (u3 - u2) * d1 * m2;
}

inline std::vector<double> centripetal_knots(const std::vector<glm::dvec3>& points) {
    std::vector<double> knots(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t k = 1; k <= i; ++k) {
            const glm::dvec3 d = points[k] - points[k - 1];
            knots[i] += std::pow(d.x * d.x + d.y * d.y + d.z * d.z, 0.25);
        }
    return knots;
}

/// By de Casteljau's construction. A slope of three keys is that of the parabola through them, by Lagrange's formula.
inline double knot_at(const std::vector<double>& times_s, const std::vector<double>& knots, double time_s) {
    const size_t last = knots.size() - 1;
    if (time_s <= times_s[0]) return knots[0];
    if (time_s >= times_s[last]) return knots[last];
    const auto mean = [&](size_t a, size_t b) { return (knots[b] - knots[a]) / (times_s[b] - times_s[a]); };
    const auto slope = [&](size_t k) {
        if (k == 0 || k == last) return k == 0 ? mean(0, 1) : mean(last - 1, last);
        const double a = times_s[k - 1], b = times_s[k], c = times_s[k + 1];
        const double parabola = knots[k - 1] * (b - c) / ((a - b) * (a - c)) +
                                knots[k] * (2 * b - a - c) / ((b - a) * (b - c)) +
                                knots[k + 1] * (b - a) / ((c - a) * (c - b));
        return std::min(parabola, 2 * std::min(mean(k - 1, k), mean(k, k + 1)));
    };
    size_t i = last - 1;
    while (times_s[i] > time_s) --i;
    const double third = (times_s[i + 1] - times_s[i]) / 3, u = (time_s - times_s[i]) / (3 * third);
    std::array<double, 4> b{knots[i], knots[i] + third * slope(i), knots[i + 1] - third * slope(i + 1), knots[i + 1]};
    for (size_t n = 3; n > 0; --n)
        for (size_t k = 0; k < n; ++k) b[k] += u * (b[k + 1] - b[k]);
    return b[0];
}

/// By bisection.
inline double arc_length(const std::vector<glm::dvec3>& points, double share) {
    const int n = int(points.size()) - 1;
    const auto covered = [&](double u) {
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            const double part = std::clamp(u * n - i, 0.0, 1.0);
            sum += part * glm::distance(points[size_t(i)], points[size_t(i) + 1]);
        }
        return sum;
    };
    if (!(share > 0)) return 0;
    if (share >= 1) return 1;
    const double all = covered(1);
    if (all <= 0) return share;
    double lower = 0, upper = 1;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (lower + upper);
        (covered(middle) < share * all ? lower : upper) = middle;
    }
    return upper;
}

/// As a matrix.
inline glm::dvec3 up_without_roll(glm::dvec3 up, glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), angle = std::atan2(sine, glm::dot(from, to));
    if (glm::length(from + to) < 1e-6 || sine == 0) return up;
    return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis / sine) * glm::dvec4(up, 0.0));
}

inline glm::dvec3 fade_linear_light(glm::dvec3 light, double black, double white) {
    const double left = std::pow(1 - std::clamp(black, 0.0, 1.0), 2.2),
                 way = std::pow(std::clamp(white, 0.0, 1.0), 2.2);
    for (int i = 0; i < 3; ++i) {
        light[i] *= left;
        if (light[i] < 16) light[i] += way * (16 - light[i]);
    }
    return light;
}

/// By picking the next one again and again.
inline std::vector<int> warm(const std::vector<OnScreen>& scenes, double now_s, double ahead_s, int most) {
    std::vector<int> ready;
    for (const bool on_screen : {true, false})
        for (;;) {
            int next = -1;
            for (int i = 0; i < int(scenes.size()); ++i) {
                const auto [from, to] = scenes[size_t(i)];
                const bool wanted = on_screen ? from <= now_s && now_s < to : from > now_s && from <= now_s + ahead_s;
                const bool had = std::find(ready.begin(), ready.end(), i) != ready.end();
                if (wanted && !had && (next < 0 || from < scenes[size_t(next)].from_s)) next = i;
            }
            if (next < 0 || (!on_screen && int(ready.size()) >= most)) break;
            ready.push_back(next);
        }
    return ready;
}

}  // namespace lightwalk::truth
