#include "12_skin/sums.h"

#include <cmath>

#include "common/base/error.h"

namespace lightwalk {

std::vector<Gaussian> merged(const std::vector<size_t>& kept) {
    std::vector<Gaussian> sum;
    for (const size_t i : kept) sum.push_back({glm::vec3(0), glm::vec3(skin_variance_mm2[i])});
    for (size_t i = 0; i < SKIN_GAUSSIANS; ++i) {
        const auto apart = [&](const Gaussian& g) { return std::fabs(std::log(skin_variance_mm2[i] / g.variance.x)); };
        Gaussian* nearest = &sum.front();
        for (Gaussian& g : sum)
            if (apart(g) < apart(*nearest)) nearest = &g;
        nearest->weight += skin_weight[i];
    }
    return sum;
}

std::vector<Gaussian> gaussians_of(int count) {
    switch (count) {
        case 1: {
            Gaussian one{glm::vec3(0), glm::vec3(0)};
            for (size_t i = 0; i < SKIN_GAUSSIANS; ++i) {
                one.weight += skin_weight[i];
                one.variance += skin_weight[i] * skin_variance_mm2[i];
            }
            return {one};
        }
        case 2:
            return merged({0, 4});
        case 3:
            return merged({0, 1, 4});
        case 4:
            return merged({0, 1, 2, 4});
        case 6:
            return merged({0, 1, 2, 3, 4, 5});
        default:
            throw Failure("there is no sum of {} Gaussians; there are sums of 1, 2, 3, 4 and 6", count);
    }
}

glm::dvec3 step_edge(const std::vector<Gaussian>& sum, double x_mm) {
    glm::dvec3 light(0);
    for (const Gaussian& g : sum)
        for (int c = 0; c < 3; ++c)
            light[c] += double(g.weight[c]) * 0.5 * std::erfc(-x_mm / std::sqrt(2 * double(g.variance[c])));
    return light;
}

std::vector<glm::vec4> line_kernel(int side) {
    constexpr double widest_mm = 8.2;
    const std::vector<Gaussian> all = gaussians_of(6);
    const auto offset = [&](double k) { return widest_mm * k * std::fabs(k) / (side * side); };
    std::vector<glm::vec4> kernel;
    glm::dvec3 whole(0);
    for (int k = -side; k <= side; ++k) {
        // All light between the middles to the neighbours is taken at one place.
        const double from = 0.5 * (offset(k - 1) + offset(k)), to = 0.5 * (offset(k) + offset(k + 1));
        const glm::dvec3 share = step_edge(all, to) - step_edge(all, from);
        whole += share;
        kernel.emplace_back(glm::vec3(share), static_cast<float>(offset(k)));
    }
    for (glm::vec4& tap : kernel) tap = glm::vec4(glm::vec3(glm::dvec3(tap) / whole), tap.w);
    return kernel;
}

}  // namespace lightwalk
