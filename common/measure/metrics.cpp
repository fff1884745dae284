#include "common/measure/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/base/error.h"

namespace lightwalk {
namespace {

template <class Image>
void check_sizes(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height)
        throw InputError("the images differ in size: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
}

void count(glm::vec3 p, NonFinite& into) {
    const glm::bvec3 nan = glm::isnan(p), inf = glm::isinf(p);
    if (glm::any(nan))
        ++into.nan;
    else if (glm::any(inf))
        ++into.inf;
}

}  // namespace

NonFinite count_non_finite(const ImageRgb& image) {
    NonFinite counts;
    for (const glm::vec3& p : image.pixels) count(p, counts);
    return counts;
}

Difference difference(const ImageRgb& reference, const ImageRgb& test) {
    check_sizes(reference, test);
    Difference d;
    double squares = 0.0, relative_squares = 0.0;
    for (size_t i = 0; i < reference.pixels.size(); ++i) {
        const size_t before = d.reference.total() + d.test.total();
        count(reference.pixels[i], d.reference);
        count(test.pixels[i], d.test);
        if (d.reference.total() + d.test.total() != before) continue;
        ++d.pixels;
        for (int c = 0; c < 3; ++c) {
            const double r = reference.pixels[i][c], error = test.pixels[i][c] - r;
            squares += error * error;
            relative_squares += error * error / (r * r + relative_epsilon);
            d.max = std::max(d.max, std::abs(error));
        }
    }
    const double values = 3.0 * static_cast<double>(d.pixels);  // no pixels: 0 / 0 gives the documented NaN
    d.mse = squares / values;
    d.rmse = std::sqrt(d.mse);
    d.relative_rmse = std::sqrt(relative_squares / values);
    return d;
}

double psnr_db(double mse, double peak) {
    return mse > 0.0
               ? 10.0 * std::log10(peak * peak / mse)
               : (mse == 0.0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN());
}

StepDifference max_step_difference(const Image8& reference, const Image8& test) {
    check_sizes(reference, test);
    StepDifference worst;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const glm::ivec4 d = glm::abs(glm::ivec4(reference.at(x, y)) - glm::ivec4(test.at(x, y)));
            const int steps = std::max({d.r, d.g, d.b, d.a});
            if (steps > 0) ++worst.pixels;
            if (steps > worst.steps) {
                worst.steps = steps;
                worst.x = x;
                worst.y = y;
            }
        }
    return worst;
}

bool is_nearly_constant(const Image8& image, int steps, double share) {
    if (image.pixels.empty()) return true;
    glm::ivec3 middle(0);
    for (int c = 0; c < 3; ++c) {
        std::array<size_t, 256> histogram{};
        for (const glm::u8vec4& p : image.pixels) ++histogram[p[c]];
        size_t below = 0;
        while (2 * (below += histogram[size_t(middle[c])]) < image.pixels.size()) ++middle[c];
    }
    size_t apart = 0;
    for (const glm::u8vec4& p : image.pixels) {
        const glm::ivec3 d = glm::abs(glm::ivec3(p) - middle);
        if (std::max({d.r, d.g, d.b}) > steps) ++apart;
    }
    return static_cast<double>(apart) < share * static_cast<double>(image.pixels.size());
}

}  // namespace lightwalk
