// FLIP a second time, straight from the 2020 paper: double precision, 2-D kernels summed pixel by pixel, the
// opponent-space matrix as rational numbers. Shares no code with common/measure. Slow: for images of a few hundred
// pixels.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "common/image/image.h"

namespace flip_truth {

constexpr double pi = 3.14159265358979323846;

struct Vec {
    double x, y, z;
};

/// Rec. 709 to XYZ with white (0.31271, 0.32902), as fractions.
inline Vec xyz(Vec c) {
    return {10135552.0 / 24577794 * c.x + 8788810.0 / 24577794 * c.y + 4435075.0 / 24577794 * c.z,
            2613072.0 / 12288897 * c.x + 8788810.0 / 12288897 * c.y + 887015.0 / 12288897 * c.z,
            1425312.0 / 73733382 * c.x + 8788810.0 / 73733382 * c.y + 70074185.0 / 73733382 * c.z};
}

/// The inverse by Cramer's rule.
inline Vec rgb(Vec v) {
    const Vec r = xyz({1, 0, 0}), g = xyz({0, 1, 0}), b = xyz({0, 0, 1});
    const auto det = [](Vec p, Vec q, Vec s) {
        return p.x * (q.y * s.z - q.z * s.y) - q.x * (p.y * s.z - p.z * s.y) + s.x * (p.y * q.z - p.z * q.y);
    };
    const double whole = det(r, g, b);
    return {det(v, g, b) / whole, det(r, v, b) / whole, det(r, g, v) / whole};
}

inline Vec white() { return xyz({1, 1, 1}); }

inline Vec opponent(Vec c) {
    const Vec v = xyz(c), w = white();
    return {116 * v.y / w.y - 16, 500 * (v.x / w.x - v.y / w.y), 200 * (v.y / w.y - v.z / w.z)};
}

inline Vec opponent_to_rgb(Vec o) {
    const Vec w = white();
    const double y = (o.x + 16) / 116;
    return rgb({(y + o.y / 500) * w.x, y * w.y, (y - o.z / 200) * w.z});
}

/// CIELAB of a linear colour, a and b scaled by L / 100.
inline Vec hunt_lab(Vec c) {
    const Vec v = xyz(c), w = white();
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::pow(t, 1.0 / 3) : (24389.0 / 27 * t + 16) / 116; };
    const double l = 116 * f(v.y / w.y) - 16;
    return {l, l / 100 * 500 * (f(v.x / w.x) - f(v.y / w.y)), l / 100 * 200 * (f(v.y / w.y) - f(v.z / w.z))};
}

inline double hyab(Vec p, Vec q) { return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z); }

/// The colour difference of two linear colours, each seen over a wide area.
inline double colour_difference(Vec p, Vec q) {
    const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
    const double d = std::pow(hyab(hunt_lab(p), hunt_lab(q)), 0.7);
    const double knee = 0.4 * largest;
    return d < knee ? 0.95 * d / knee : 0.95 + 0.05 * (d - knee) / (largest - knee);
}

using Field = std::function<double(int x, int y)>;  // pixel coordinates may lie outside: the border repeats

/// A sum over a square window of weight(dx, dy) * field.
inline double convolve(const Field& field, int x, int y, int radius, const std::function<double(int, int)>& weight) {
    double total = 0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) total += weight(dx, dy) * field(x + dx, y + dy);
    return total;
}

/// Scales a kernel's positive weights to sum to 1 and its negative ones to sum to -1.
inline std::function<double(int, int)> balanced(int radius, const std::function<double(int, int)>& raw) {
    double positive = 0, negative = 0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) (raw(dx, dy) > 0 ? positive : negative) += raw(dx, dy);
    if (negative == 0) negative = -1;
    return [=](int dx, int dy) { return raw(dx, dy) > 0 ? raw(dx, dy) / positive : -raw(dx, dy) / negative; };
}

/// LDR-FLIP of linear images in [0, 1], rows from the top.
inline std::vector<double> flip(const lightwalk::ImageRgb& a, const lightwalk::ImageRgb& b, double per_degree) {
    const int w = a.width, h = a.height;
    const auto colour = [&](const lightwalk::ImageRgb& image, int x, int y) {
        const glm::vec3 p = image.at(std::clamp(x, 0, w - 1), std::clamp(y, 0, h - 1));
        return Vec{double(p.x), double(p.y), double(p.z)};
    };
    // Spatial filters: a1, b1, a2, b2 of the contrast sensitivity in each opponent channel.
    const double sensitivity[3][4] = {{1, .0047, 0, 1e-5}, {1, .0053, 0, 1e-5}, {34.1, .04, 13.5, .025}};
    const int spatial_radius = int(std::ceil(3 * std::sqrt(.04 / (2 * pi * pi)) * per_degree));
    std::vector<std::function<double(int, int)>> spatial;
    for (const auto& s : sensitivity)
        spatial.push_back(balanced(spatial_radius, [=](int dx, int dy) {
            const double d2 = (dx * dx + dy * dy) / (per_degree * per_degree);
            return s[0] * std::sqrt(pi / s[1]) * std::exp(-pi * pi * d2 / s[1]) +
                   s[2] * std::sqrt(pi / s[3]) * std::exp(-pi * pi * d2 / s[3]);
        }));
    const double sigma = 0.5 * 0.082 * per_degree;
    const int feature_radius = int(std::ceil(3 * sigma));
    const auto gauss = [=](int dx, int dy) { return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)); };
    const auto edge = balanced(feature_radius, [=](int dx, int dy) { return -dx * gauss(dx, dy); });
    const auto point =
        balanced(feature_radius, [=](int dx, int dy) { return (dx * dx / (sigma * sigma) - 1) * gauss(dx, dy); });

    const auto seen = [&](const lightwalk::ImageRgb& image, int x, int y) {
        double c[3];
        for (int i = 0; i < 3; ++i)
            c[i] = convolve(
                [&](int px, int py) {
                    const Vec o = opponent(colour(image, px, py));
                    return i == 0 ? o.x : i == 1 ? o.y : o.z;
                },
                x, y, spatial_radius, spatial[size_t(i)]);
        const Vec back = opponent_to_rgb({c[0], c[1], c[2]});
        return Vec{std::clamp(back.x, 0., 1.), std::clamp(back.y, 0., 1.), std::clamp(back.z, 0., 1.)};
    };
    const auto feature = [&](const lightwalk::ImageRgb& image, int x, int y, const auto& kernel) {
        const Field luminance = [&](int px, int py) { return xyz(colour(image, px, py)).y / white().y; };
        const double gx = convolve(luminance, x, y, feature_radius, kernel);
        const double gy = convolve(luminance, x, y, feature_radius, [&](int dx, int dy) { return kernel(dy, dx); });
        return std::hypot(gx, gy);
    };
    std::vector<double> map;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double colour_error = colour_difference(seen(a, x, y), seen(b, x, y));
            const double edges = std::abs(feature(a, x, y, edge) - feature(b, x, y, edge));
            const double points = std::abs(feature(a, x, y, point) - feature(b, x, y, point));
            map.push_back(std::pow(colour_error, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0))));
        }
    return map;
}

}  // namespace flip_truth
