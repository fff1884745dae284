// right
#include <cmath>

#include "14_environment/exercises.h"

namespace lightwalk::exercise {

glm::vec3 spectrum_bands(const std::vector<float>& samples, float rate_hz) {
    double square[3] = {}, count[3] = {};
    for (int k = 1; k <= 1024; ++k) {
        const float f = k * rate_hz / 2048;
        const int band = f < 20 ? -1 : f < 250 ? 0 : f < 4000 ? 1 : f < 20000 ? 2 : -1;
        if (band < 0) continue;
        double re = 0, im = 0;
        for (int n = 0; n < 2048; ++n) {
            const double a = 2 * M_PI * (k * n % 2048) / 2048, w = std::pow(std::sin(M_PI * n / 2048), 2);
            re += w * samples[n] * std::cos(a);
            im -= w * samples[n] * std::sin(a);
        }
        square[band] += (re * re + im * im) / 512 / 512;
        count[band]++;
    }
    glm::vec3 out(0);
    for (int b = 0; b < 3; ++b)
        if (count[b]) out[b] = std::sqrt(square[b] / count[b]);
    return out;
}

}  // namespace lightwalk::exercise
