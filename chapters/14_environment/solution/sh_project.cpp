#include <cmath>

#include "14_environment/exercises.h"

namespace lightwalk::solution {

// The constants: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps",
// SIGGRAPH 2001, equation 3.
Sh9 sh_project(int width, int height, const std::vector<glm::vec3>& texels) {
    const double pi = 3.14159265358979323846;
    const double high = pi / height, wide = 2 * pi / width;
    Sh9 sums(9);
    for (int row = 0; row < height; ++row) {
        const double theta = (row + 0.5) * high;
        const double solid_angle = wide * (std::cos(row * high) - std::cos((row + 1) * high));
        for (int column = 0; column < width; ++column) {
            const double phi = (column + 0.5) * wide - pi;
            const double x = std::sin(phi) * std::sin(theta), y = std::cos(theta), z = -std::cos(phi) * std::sin(theta);
            const double basis[9] = {0.282095,
                                     0.488603 * y,
                                     0.488603 * z,
                                     0.488603 * x,
                                     1.092548 * x * y,
                                     1.092548 * y * z,
                                     0.315392 * (3 * z * z - 1),
                                     1.092548 * x * z,
                                     0.546274 * (x * x - y * y)};
            const glm::dvec3 light = solid_angle * glm::dvec3(texels[size_t(row) * size_t(width) + size_t(column)]);
            for (size_t i = 0; i < sums.size(); ++i) sums[i] += basis[i] * light;
        }
    }
    return sums;
}

}  // namespace lightwalk::solution
