// The reference for tone curves in double precision: ACES 1.0's RRT and its ODT for Rec. 709 at 100 nits in dim
// surround. Academy of Motion Picture Arts and Sciences, "Academy Color Encoding System", 2014; constants as published
// there.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace lightwalk::truth {

inline glm::dvec3 xyz_of(glm::dvec2 xy) { return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y}; }

/// From linear RGB with these primaries and this white, chromaticities, to XYZ.
inline glm::dmat3 rgb_to_xyz(glm::dvec2 red, glm::dvec2 green, glm::dvec2 blue, glm::dvec2 white) {
    const glm::dmat3 primaries(xyz_of(red), xyz_of(green), xyz_of(blue));
    const glm::dvec3 share = glm::inverse(primaries) * xyz_of(white);
    return {primaries[0] * share.x, primaries[1] * share.y, primaries[2] * share.z};
}

constexpr glm::dvec2 d65{0.3127, 0.3290}, aces_white{0.32168, 0.33767};
inline glm::dmat3 rec709_to_xyz() { return rgb_to_xyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65); }
inline glm::dmat3 ap0_to_xyz() { return rgb_to_xyz({0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, aces_white); }
inline glm::dmat3 ap1_to_xyz() { return rgb_to_xyz({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, aces_white); }

/// K. M. Lam's Bradford transform (1985): XYZ under one white to XYZ under another.
inline glm::dmat3 bradford(glm::dvec2 from, glm::dvec2 to) {
    const glm::dmat3 cones(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
    const glm::dvec3 gain = (cones * xyz_of(to)) / (cones * xyz_of(from));
    return glm::inverse(cones) * glm::dmat3(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z) * cones;
}

/// A curve from log10 of light to log10 of light: quadratic B-splines below and above a middle.
template <size_t N>
struct LogCurve {
    std::array<double, N> low, high;
    double least, middle, most;  ///< log10
    double bottom, top, slope;   ///< values outside, and how it goes on above

    double operator()(double l) const {
        if (l <= least) return bottom;
        if (l >= most) return top + slope * (l - most);
        const bool below = l < middle;
        const auto& c = below ? low : high;
        const double share = below ? (l - least) / (middle - least) : (l - middle) / (most - middle);
        const double at = double(N - 3) * share;
        const auto j = std::min(static_cast<size_t>(at), N - 4);
        const double t = at - double(j);
        // The B-spline's basis on one span.
        return c[j] * (1 - t) * (1 - t) / 2 + c[j + 1] * (0.5 + t - t * t) + c[j + 2] * t * t / 2;
    }
};

inline const LogCurve<6>& rrt_curve() {
    static const LogCurve<6> curve{{-4.0, -4.0, -3.1573765773, -0.4852499958, 1.8477324706, 1.8477324706},
                                   {-0.7185482425, 2.0810307172, 3.6681241237, 4.0, 4.0, 4.0},
                                   std::log10(0.18 * std::exp2(-15.0)),
                                   std::log10(0.18),
                                   std::log10(0.18 * std::exp2(18.0)),
                                   -4.0,
                                   4.0,
                                   0.0};
    return curve;
}

inline const LogCurve<10>& odt_curve() {
    static const LogCurve<10> curve{
        {-1.6989700043, -1.6989700043, -1.4779, -1.2291, -0.8648, -0.4480, 0.00518, 0.4511080334, 0.9113744414,
         0.9113744414},
        {0.5154386965, 0.8470437783, 1.1358, 1.3802, 1.5197, 1.5985, 1.6467, 1.6746091357, 1.6878733390, 1.6878733390},
        rrt_curve()(std::log10(0.18 * std::exp2(-6.5))),
        std::log10(4.8),
        rrt_curve()(std::log10(0.18 * std::exp2(6.5))),
        std::log10(0.02),
        std::log10(48.0),
        0.04};
    return curve;
}

/// Factor of the RRT's glow for saturated dark colours.
inline double glow(glm::dvec3 c, double saturation) {
    const double chroma = std::sqrt(std::max(c.b * (c.b - c.g) + c.g * (c.g - c.r) + c.r * (c.r - c.b), 0.0));
    const double yc = (c.r + c.g + c.b + 1.75 * chroma) / 3.0, x = (saturation - 0.4) / 0.2;
    const double t = std::max(1.0 - std::fabs(x / 2), 0.0);
    const double gain = 0.05 * (1.0 + (x < 0 ? -1.0 : x > 0 ? 1.0 : 0.0) * (1.0 - t * t)) / 2;
    if (yc <= 2.0 / 3.0 * 0.08) return 1.0 + gain;
    return yc >= 2 * 0.08 ? 1.0 : 1.0 + gain * (0.08 / yc - 0.5);
}

/// The RRT's weight of red: a cubic B-spline over 135 degrees of hue, 1 at red itself.
inline double redness(glm::dvec3 c) {
    const double across = std::sqrt(3.0) * (c.g - c.b), along = 2 * c.r - c.g - c.b;
    if (across == 0 && along == 0) return 1.0;  // grey: saturation 0
    const double u = std::fabs(std::atan2(across, along)) * 180.0 / 3.141592653589793 * 4.0 / 135.0;
    if (u >= 2) return 0.0;
    return 1.5 * (u < 1 ? (4 - 6 * u * u + 3 * u * u * u) / 6 : std::pow(2 - u, 3.0) / 6);
}

inline double ap1_luminance(glm::dvec3 c) {
    static const glm::dmat3 m = ap1_to_xyz();
    return m[0].y * c.r + m[1].y * c.g + m[2].y * c.b;
}
inline glm::dvec3 with_saturation(glm::dvec3 ap1, double s) { return glm::mix(glm::dvec3(ap1_luminance(ap1)), ap1, s); }

/// Scene-referred linear Rec. 709 to a screen's linear Rec. 709, 0 to 1.
inline glm::dvec3 reference_tone(glm::dvec3 radiance) {
    static const glm::dmat3 in = glm::inverse(ap0_to_xyz()) * bradford(d65, aces_white) * rec709_to_xyz();
    static const glm::dmat3 middle = glm::inverse(ap1_to_xyz()) * ap0_to_xyz();
    static const glm::dmat3 out = glm::inverse(rec709_to_xyz()) * bradford(aces_white, d65) * ap1_to_xyz();
    glm::dvec3 c = in * glm::max(radiance, glm::dvec3(0));
    const double most = std::max({c.r, c.g, c.b}), least = std::min({c.r, c.g, c.b});
    const double saturation = (std::max(most, 1e-10) - std::max(least, 1e-10)) / std::max(most, 1e-2);
    c *= glow(c, saturation);
    c.r += redness(c) * saturation * (0.03 - c.r) * (1.0 - 0.82);
    glm::dvec3 film = glm::clamp(middle * glm::max(c, glm::dvec3(0)), 0.0, 65504.0);
    film = glm::clamp(with_saturation(film, 0.96), 1e-10, 65504.0);
    glm::dvec3 screen;
    for (int i = 0; i < 3; ++i)
        screen[i] = (std::pow(10.0, odt_curve()(rrt_curve()(std::log10(film[i])))) - 0.02) / (48.0 - 0.02);
    if (const double y = ap1_luminance(screen); y > 0) screen *= std::pow(y, 0.9811 - 1.0);
    return glm::clamp(out * with_saturation(screen, 0.93), 0.0, 1.0);
}

}  // namespace lightwalk::truth
