// wrong: weight 1 is
#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<float> gaussian_weights(float sigma_px, float truncation) {
    if (sigma_px == 0) return {1};
    const int radius = (int)std::ceil(truncation * sigma_px);
    std::vector<double> w;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        w.push_back(std::exp(-1.0 * i * i / (double(sigma_px) * sigma_px)));
        sum += i ? 2 * w[i] : w[i];
    }
    std::vector<float> r;
    for (double x : w) r.push_back(x / sum);
    return r;
}

}  // namespace lightwalk::exercise
