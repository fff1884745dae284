#include "04_surface_maps/height_field.h"

#include <algorithm>
#include <array>

namespace lightwalk {
namespace {

constexpr int halvings = 8;  // as in surface_maps.glsl

// Real roots of a r^2 + b r + c, ascending; NaN: none.
std::array<double, 2> roots(double a, double b, double c) {
    const double root = std::sqrt(b * b - 4 * a * c);  // NaN below 0
    const double q = -0.5 * (b + std::copysign(root, b));
    const double one = q / a, two = c / q;  // an infinity where a or q is 0
    return {std::min(one, two), std::max(one, two)};
}

}  // namespace

double HeightField::texel(glm::ivec2 at) const {
    const glm::ivec2 in = (at % size_ + size_) % size_;
    return 1.0 - double(heights_[size_t(in.y) * size_t(size_.x) + size_t(in.x)]);
}

double HeightField::depth(glm::dvec2 at) const {
    const glm::ivec2 cell(glm::floor(at));
    const glm::dvec2 p = at - glm::dvec2(cell);
    const double top = glm::mix(texel(cell), texel(cell + glm::ivec2(1, 0)), p.x);
    const double bottom = glm::mix(texel(cell + glm::ivec2(0, 1)), texel(cell + 1), p.x);
    return glm::mix(top, bottom, p.y);
}

double HeightField::exact(glm::dvec2 start, glm::dvec2 along) const {
    // Segments between crossings of texel-centre lines, with a quadratic equation each.
    std::vector<double> crossings{0.0, 1.0};
    for (int axis = 0; axis < 2; ++axis) {
        const double from = start[axis], to = start[axis] + along[axis];
        for (double line = std::ceil(std::min(from, to)); line <= std::max(from, to) && along[axis] != 0; ++line)
            crossings.push_back(std::clamp((line - from) / along[axis], 0.0, 1.0));
    }
    std::sort(crossings.begin(), crossings.end());
    for (size_t i = 0; i + 1 < crossings.size(); ++i) {
        const double t0 = crossings[i], length = crossings[i + 1] - t0;
        if (t0 >= depth(start + t0 * along)) return t0;
        if (length < 1e-14) continue;
        // Coefficients from three values.
        const auto gap = [&](double r) { return depth(start + (t0 + r * length) * along) - (t0 + r * length); };
        const double y0 = gap(0), y1 = gap(0.5), y2 = gap(1 - 1e-12);
        const double a = 2 * (y0 - 2 * y1 + y2), b = y2 - y0 - a;
        for (const double r : roots(a, b, y0))
            if (r >= 0 && r <= 1) return t0 + r * length;
    }
    return 1.0;
}

double HeightField::hit(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along) const {
    const auto gap = [&](double t) { return depth(start + t * along) - t; };
    if (method == "flat" || method == "normal") return 0;
    if (method == "offset" || method == "offset_limited") return depth(start);
    if (method == "exact") return exact(start, along);
    int i = 0;
    while (i < steps && gap(double(i) / steps) > 0) ++i;
    double below = double(i) / steps, above = std::max(below - 1.0 / steps, 0.0);
    if (method == "steep" || i == 0) return below;
    if (method == "occlusion") return above + (below - above) * gap(above) / (gap(above) - gap(below));
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (above + below);
        (gap(middle) <= 0 ? below : above) = middle;
    }
    return below;
}

glm::dvec2 HeightField::place(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along,
                              double cosine) const {
    const double t = hit(method, steps, start, along);
    return start + t * along * (method == "offset_limited" ? cosine : 1.0);
}

}  // namespace lightwalk
