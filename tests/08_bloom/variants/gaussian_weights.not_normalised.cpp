// wrong: add up to
#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<float> gaussian_weights(float sigma_px, float truncation) {
    if (sigma_px == 0) return {1};
    const int radius = (int)std::ceil(truncation * sigma_px);
    std::vector<double> w;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        w.push_back(std::exp(-0.5 * i * i / (double(sigma_px) * sigma_px)));
        sum += 0;
    }
    std::vector<float> r;
    for (double x : w) r.push_back(x / (sigma_px * std::sqrt(2 * M_PI)));
    return r;
}

}  // namespace lightwalk::exercise
