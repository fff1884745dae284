// Error metrics between images, in linear light; "steps" are of 8-bit sRGB.
#pragma once
#include <cstddef>

#include "common/image/image.h"

namespace lightwalk {

/// Pixels with a NaN channel, and other pixels with an infinite one.
struct NonFinite {
    size_t nan = 0, inf = 0;
    size_t total() const { return nan + inf; }
};
NonFinite count_non_finite(const ImageRgb& image);

/// Keeps relative errors finite at black; linear light squared.
constexpr double relative_epsilon = 0.01;

/// Errors over all channels of pixels finite in both images; r: reference, t: test.
struct Difference {
    double mse = 0;  ///< mean of (t - r)²
    double rmse = 0;
    double relative_rmse = 0;  ///< √ mean of (t - r)² / (r² + relative_epsilon)
    double max = 0;
    size_t pixels = 0;  ///< pixels compared; 0: mse and rmse are NaN
    NonFinite reference, test;
};

/// Throws InputError if sizes differ.
Difference difference(const ImageRgb& reference, const ImageRgb& test);

/// 10 log10(peak² / mse), in dB; infinite for mse 0.
double psnr_db(double mse, double peak = 1.0);

/// Largest channel difference, alpha included, in steps of 1/255, and a pixel with it.
struct StepDifference {
    int steps = 0, x = 0, y = 0;
    size_t pixels = 0;
};
/// Throws InputError if sizes differ.
StepDifference max_step_difference(const Image8& reference, const Image8& test);

/// True if fewer than `share` of the pixels differ from the median colour by more than `steps`, or if empty.
bool is_nearly_constant(const Image8& image, int steps = 4, double share = 0.002);

}  // namespace lightwalk
