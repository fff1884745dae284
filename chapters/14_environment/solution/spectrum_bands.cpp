#include <cmath>

#include "14_environment/exercises.h"
#include "14_environment/spectrum.h"

namespace lightwalk::solution {

glm::vec3 spectrum_bands(const std::vector<float>& samples, float rate_hz) {
    std::vector<float> windowed = samples;
    for (size_t n = 0; n < windowed.size(); ++n)
        windowed[n] *= static_cast<float>(0.5 - 0.5 * std::cos(2 * M_PI * double(n) / 2048));
    const std::vector<std::complex<float>> bins = spectrum_of(windowed);

    // 10 to 683 squares are added: in double no level depends on their order.
    constexpr double edges_hz[] = {20, 250, 4000, 20000};
    glm::vec3 levels(0.0f);
    for (int band = 0; band < 3; ++band) {
        double sum = 0;
        int count = 0;
        for (size_t k = 0; k < bins.size(); ++k) {
            const double frequency_hz = double(k) * double(rate_hz) / 2048;
            if (frequency_hz < edges_hz[band] || frequency_hz >= edges_hz[band + 1]) continue;
            sum += double(std::norm(bins[k])) / (512.0 * 512.0);
            ++count;
        }
        if (count > 0) levels[band] = static_cast<float>(std::sqrt(sum / count));
    }
    return levels;
}

}  // namespace lightwalk::solution
