// right
#include <cmath>

#include "14_environment/exercises.h"
#include "14_environment/spectrum.h"

namespace lightwalk::exercise {

glm::vec3 spectrum_bands(const std::vector<float>& samples, float rate_hz) {
    std::vector<float> x(2048);
    for (int n = 0; n < 2048; ++n) x[n] = samples[n] * (0.5f - 0.5f * std::cos(2.0f * float(M_PI) * n / 2048.0f));
    const auto X = spectrum_of(x);
    const float edges[] = {20, 250, 4000, 20000};
    glm::vec3 sum(0), n(0);
    for (int k = 0; k <= 1024; ++k)
        for (int b = 0; b < 3; ++b)
            if (const float f = k * (rate_hz / 2048.0f); f >= edges[b] && f < edges[b + 1]) {
                sum[b] += std::norm(X[k] / 512.0f);
                n[b] += 1;
            }
    return glm::sqrt(sum / glm::max(n, 1.0f));
}

}  // namespace lightwalk::exercise
