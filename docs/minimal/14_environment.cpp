// [minimal]
// A picture of the surroundings as a light for matt surfaces: nine colours hold nearly all that matters (R. Ramamoorthi
// and P. Hanrahan, SIGGRAPH 2001). The sum over every direction, for each normal, is the reference.
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>

using glm::dvec3;
constexpr double pi = 3.14159265358979;

// The radiance that arrives from a direction: a real program reads a photograph. Sky, ground, and a bright window.
dvec3 radiance(dvec3 from) {
    const dvec3 sky = from.y > 0 ? dvec3(0.4, 0.6, 1) : dvec3(0.25, 0.2, 0.15);
    return sky + 8.0 * dvec3(1, 0.9, 0.7) * double(glm::dot(from, glm::normalize(dvec3(1, 0.7, 0.2))) > 0.94);
}

// The spherical harmonics up to the second order, without their factors: orthogonal functions over directions.
std::array<double, 9> basis(dvec3 d) {
    return {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, d.x * d.z, d.x * d.x - d.y * d.y, 3 * d.z * d.z - 1};
}
// The factors, squared (1 / 4 pi for the first), times the cosine's own for each order: pi, 2 pi / 3, pi / 4.
const double weights[9] = {1.0 / 4, 1.0 / 2, 1.0 / 2, 1.0 / 2, 15.0 / 16, 15.0 / 16, 15.0 / 16, 15.0 / 64, 5.0 / 64};

// The i-th of n directions that are spread evenly over the sphere: each stands for 4 pi / n of solid angle.
dvec3 direction(int i, int n) {
    const double y = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - y * y), turn = 2.39996323 * i;  // the golden angle
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

int main() {
    constexpr int n = 20000;
    // 1. Once for a picture: how much of each basis function it holds.
    std::array<dvec3, 9> colors{};
    for (int i = 0; i < n; ++i) {
        const dvec3 from = direction(i, n), light = radiance(from) * 4.0 * pi / double(n);
        for (size_t k = 0; k < 9; ++k) colors[k] += light * basis(from)[k];
    }
    // 2. For each pixel: the irradiance on a surface.
    const auto irradiance = [&](dvec3 normal) {
        dvec3 sum(0);
        for (size_t k = 0; k < 9; ++k) sum += weights[k] * basis(normal)[k] * colors[k];
        return glm::max(sum, dvec3(0));
    };
    // 3. Against the sum over all directions.
    double worst = 0, mean = 0;
    for (int j = 0; j < 100; ++j) {
        double exact = 0;  // of green
        for (int i = 0; i < n; ++i)
            exact +=
                radiance(direction(i, n)).g * std::fmax(glm::dot(direction(j, 100), direction(i, n)), 0) * 4 * pi / n;
        worst = std::fmax(worst, std::fabs(irradiance(direction(j, 100)).g - exact));
        mean += exact / 100;
    }
    std::printf("mean %.4f\nworst %.4f\n", mean, worst);
}
// [/minimal]
