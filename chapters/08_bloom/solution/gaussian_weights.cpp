#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::solution {

std::vector<float> gaussian_weights(float sigma_px, float truncation) {
    if (sigma_px == 0.0f) return {1.0f};
    const double sigma = static_cast<double>(sigma_px);
    std::vector<double> exact;
    double sum = 0;
    const int radius = static_cast<int>(std::ceil(truncation * sigma_px));
    for (int d = 0; d <= radius; ++d) {
        exact.push_back(std::exp(-0.5 * (d / sigma) * (d / sigma)));
        sum += d == 0 ? exact.back() : 2 * exact.back();
    }
    std::vector<float> weights;
    for (const double weight : exact) weights.push_back(static_cast<float>(weight / sum));
    return weights;
}

}  // namespace lightwalk::solution
