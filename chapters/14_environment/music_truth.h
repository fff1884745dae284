// References in double precision for the levels of music.
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace lightwalk::truth {

/// The discrete Fourier transform from its definition, k = 0 to N / 2.
inline std::vector<std::complex<double>> spectrum_of(const std::vector<double>& samples) {
    const size_t count = samples.size();
    std::vector<std::complex<double>> turn(count), bins(count / 2 + 1);
    for (size_t i = 0; i < count; ++i) turn[i] = std::polar(1.0, -2 * M_PI * double(i) / double(count));
    for (size_t k = 0; k < bins.size(); ++k)
        for (size_t n = 0; n < count; ++n) bins[k] += samples[n] * turn[k * n % count];
    return bins;
}

inline double hann(size_t n, size_t count) { return 0.5 - 0.5 * std::cos(2 * M_PI * double(n) / double(count)); }

/// Amplitudes of a windowed stretch: 1 where a tone of amplitude 1 is.
inline std::vector<double> amplitudes(const std::vector<float>& samples,
                                      const std::function<double(size_t, size_t)>& window = hann) {
    std::vector<double> windowed(samples.size());
    double sum = 0;
    for (size_t n = 0; n < samples.size(); ++n) {
        const double weight = window(n, samples.size());
        windowed[n] = weight * double(samples[n]);
        sum += weight;
    }
    std::vector<double> found;
    for (const std::complex<double>& bin : spectrum_of(windowed)) found.push_back(std::abs(bin) * 2 / sum);
    return found;
}

/// Truth of 14.spectrum_bands, for any even number of samples.
inline glm::dvec3 spectrum_bands(const std::vector<float>& samples, double rate_hz) {
    constexpr std::array<double, 4> edges_hz{20, 250, 4000, 20000};
    const std::vector<double> found = amplitudes(samples);
    glm::dvec3 square(0.0), count(0.0);
    for (size_t k = 0; k < found.size(); ++k)
        for (int band = 0; band < 3; ++band) {
            const double frequency_hz = double(k) * rate_hz / double(samples.size());
            if (frequency_hz < edges_hz[size_t(band)] || frequency_hz >= edges_hz[size_t(band) + 1]) continue;
            square[band] += found[k] * found[k];
            ++count[band];
        }
    return glm::sqrt(square / glm::max(count, 1.0));
}

}  // namespace lightwalk::truth
