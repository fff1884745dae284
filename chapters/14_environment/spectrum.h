// The spectrum of a stretch of sound.
#pragma once
#include <complex>
#include <span>
#include <vector>

namespace lightwalk {

/// The discrete Fourier transform of `samples` (an even number of them, N): X(k) = sum of x(n) exp(-2 pi i k n / N) for
/// k = 0 to N / 2, not scaled. X(k) tells how much there is of the frequency k / N times the sample rate. Throws Failure
/// for an odd number or none.
std::vector<std::complex<float>> spectrum_of(std::span<const float> samples);

}  // namespace lightwalk
