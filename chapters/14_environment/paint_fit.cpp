#include "14_environment/paint_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lightwalk {
namespace {

constexpr double fit_pi = glm::pi<double>();

// The model is a sum of three terms, each times a colour: pigment seen straight on, pigment at grazing angles, flakes.
glm::dvec3 terms(const LightAndView& seen, double alpha) {
    const double n_dot_l = seen.to_light.z, n_dot_v = seen.to_eye.z, index = 1.5;
    const auto below = [&](double c) { return std::sqrt(1 - (1 - c * c) / (index * index)); };
    const auto through = [](double c) { return 0.96 * (1 - std::pow(1 - c, 5)); };
    const double l = below(n_dot_l), v = below(n_dot_v), a2 = alpha * alpha;
    const double edge = std::clamp(1.5 * (1 / l + 1 / v) - 3, 0.0, 1.0);
    const double l_dot_v = l * v + (glm::dot(seen.to_light, seen.to_eye) - n_dot_l * n_dot_v) / (index * index);
    const double n_dot_h = std::min((l + v) / std::sqrt(std::max(2 + 2 * l_dot_v, 1e-6)), 1.0);
    const double d = 1 + (a2 - 1) * n_dot_h * n_dot_h;
    const double visibility = 0.5 / (l * std::sqrt(v * v * (1 - a2) + a2) + v * std::sqrt(l * l * (1 - a2) + a2));
    return through(n_dot_l) * through(n_dot_v) *
           glm::dvec3((1 - edge) / fit_pi, edge / fit_pi, visibility * a2 / (fit_pi * d * d * index * index));
}

}  // namespace

PaintFit fit_paint(const MeasuredBrdf& brdf) {
    struct Sample {
        LightAndView seen;
        double weight;
        glm::dvec3 value;
    };
    std::vector<Sample> samples;
    const size_t stride = std::max<size_t>(brdf.values.size() / 50000, 1);
    size_t number = 0;
    each_cell(brdf.cells, [&](glm::ivec3 cell) {
        const LightAndView seen = directions_of(brdf.cells, cell);
        const glm::dvec3 value = glm::min(brdf.at(cell), 65504.0);  // as the device has it
        if (number++ % stride || !seen.above() || std::min({value.r, value.g, value.b}) < 0) return;
        // Solid angles of light and camera in a cell, times both cosines.
        const double x = (cell.x + 0.5) / brdf.cells.x, d = 0.5 * fit_pi * (cell.y + 0.5) / brdf.cells.y;
        const double size = x * std::sin(0.5 * fit_pi * x * x) * std::sin(d) * std::cos(d);
        samples.push_back({seen, size * seen.to_light.z * seen.to_eye.z, value});
    });
    PaintFit best;
    double least = 0;  // squared error, less that of black
    for (int step = 0; step <= 36; ++step) {
        const double roughness = 0.1 + 0.025 * step;
        glm::dmat3 normal(0), right(0);  // columns of `right`: channels
        for (const Sample& s : samples) {
            const glm::dvec3 t = terms(s.seen, roughness * roughness);
            normal += s.weight * glm::outerProduct(t, t);
            right += s.weight * glm::outerProduct(t, s.value);
        }
        if (!(glm::determinant(normal) > 1e-9 * normal[0][0] * normal[1][1] * normal[2][2])) continue;  // too few cells
        const glm::dmat3 colors = glm::inverse(normal) * right;
        double error = 0;
        for (int c = 0; c < 3; ++c) error -= glm::dot(colors[c], right[c]);
        if (!(error < least)) continue;
        least = error;
        const glm::vec3 shares(1 - best.flakes, 1 - best.flakes, best.flakes);
        const glm::mat3 by_term = glm::transpose(glm::mat3(colors));
        for (int term = 0; term < 3; ++term)
            (term == 0   ? best.color
             : term == 1 ? best.edge_color
                         : best.flake_color) = glm::max(by_term[term] / shares[term], 0.0f);
        best.flake_roughness = static_cast<float>(roughness);
    }
    return best;
}

}  // namespace lightwalk
