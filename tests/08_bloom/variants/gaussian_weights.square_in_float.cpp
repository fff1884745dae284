// wrong: weight 0 is
#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<float> gaussian_weights(float sigma_px, float truncation) {
    if (sigma_px == 0.0f) return {1.0f};
    const int radius = static_cast<int>(std::ceil(truncation * sigma_px));
    const float variance = sigma_px * sigma_px;
    std::vector<float> weights;
    double sum = 0;
    for (int d = 0; d <= radius; ++d) {
        weights.push_back(std::exp(-0.5f * static_cast<float>(d * d) / variance));
        sum += (d ? 2 : 1) * static_cast<double>(weights.back());
    }
    for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
    return weights;
}

}  // namespace lightwalk::exercise
