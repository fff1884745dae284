// References of this chapter in double precision.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk::truth {

/// CIELAB of linear light with Rec. 709 primaries, D65 (CIE 15:2004, 8.2.1; IEC 61966-2-1 for the matrix).
inline glm::dvec3 to_lab(glm::dvec3 light) {
    const double bend = 6.0 / 29;
    const auto f = [&](double t) { return t > bend * bend * bend ? std::cbrt(t) : t / (3 * bend * bend) + 4.0 / 29; };
    const double x = f((0.4124564 * light.r + 0.3575761 * light.g + 0.1804375 * light.b) / 0.95047);
    const double y = f(0.2126729 * light.r + 0.7151522 * light.g + 0.0721750 * light.b);
    const double z = f((0.0193339 * light.r + 0.1191920 * light.g + 0.9503041 * light.b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The area within pixel `position` below an outline that falls from 1/2 at 0 to 0 at length / 2; 0 for a line of one
/// pixel, which is a step of another line.
inline double area(int position, int length) {
    if (length == 1) return 0;
    const double from = std::min(double(position), 0.5 * length), to = std::min(position + 1.0, 0.5 * length);
    const auto below = [&](double x) { return 0.5 * x - 0.5 * x * x / length; };  // the integral of 1/2 - x / length
    return below(to) - below(from);
}

/// The part of the unit square around (0, 0) with dot(p - point, normal) above 0: the square clipped by a line (I. E.
/// Sutherland and G. W. Hodgman, 1974), and the area of the remainder.
inline double half_plane_coverage(glm::dvec2 point, glm::dvec2 normal) {
    const std::array<glm::dvec2, 4> square{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
    std::vector<glm::dvec2> kept;
    for (size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = square[i], b = square[(i + 1) % 4];
        const double at_a = glm::dot(a - point, normal), at_b = glm::dot(b - point, normal);
        if (at_a > 0) kept.push_back(a);
        if ((at_a > 0) != (at_b > 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    double twice = 0;
    for (size_t i = 0; i < kept.size(); ++i) {
        const glm::dvec2 a = kept[i], b = kept[(i + 1) % kept.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

/// The share that a pixel `position` pixels behind a turn has of the light across a line of `length` pixels, where
/// lines are followed for `reach` pixels to each side: that pixel's own end and the other may both lie beyond.
inline double capped_area(int position, int length, int reach) {
    if (position >= reach) return 0;  // the turn was not seen
    return area(position, position + std::min(length - position, reach));
}

/// Position in the previous frame, in pixels, of the surface `at` a position with a depth, and its clip-space w then;
/// 0 if it was not in front of the camera. `to_before`: clip space now, with w = 1, to clip space then.
inline glm::dvec3 reprojected(glm::dvec2 at, double depth, glm::dvec2 size, const glm::dmat4& to_before) {
    const glm::dvec4 then = to_before * glm::dvec4(2.0 * at / size - 1.0, depth, 1.0);
    if (then.w <= 0) return glm::dvec3(0);
    return {0.5 * size * (glm::dvec2(then) / then.w + 1.0), then.w};
}

/// The last point inside of the box on the way from its middle to `history`, by bisection.
inline glm::dvec3 clipped(glm::dvec3 history, glm::dvec3 lowest, glm::dvec3 highest) {
    const glm::dvec3 middle = 0.5 * (lowest + highest);
    const auto inside = [&](double share) {
        const glm::dvec3 at = middle + share * (history - middle);
        return glm::all(glm::greaterThanEqual(at, lowest - 1e-12)) && glm::all(glm::lessThanEqual(at, highest + 1e-12));
    };
    if (inside(1)) return history;
    double in = 0, out = 1;
    for (int i = 0; i < 60; ++i) (inside(0.5 * (in + out)) ? in : out) = 0.5 * (in + out);
    return middle + in * (history - middle);
}

}  // namespace lightwalk::truth
