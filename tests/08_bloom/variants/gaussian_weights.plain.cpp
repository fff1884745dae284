// right
#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<float> gaussian_weights(float sigma_px, float truncation) {
    const int radius = (int)std::ceil(truncation * sigma_px);
    std::vector<float> w(radius + 1, 1.0f);
    double sum = 1;
    for (int i = 1; i <= radius; ++i) {
        const double x = i / (double)sigma_px;
        sum += 2 * (w[i] = std::exp(-x * x / 2));
    }
    for (float& x : w) x /= sum;
    return w;
}

}  // namespace lightwalk::exercise
