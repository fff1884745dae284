// Errors between two images as numbers. All in linear light, unless a name says steps (of 8-bit sRGB).
#pragma once
#include <cstddef>

#include "common/image/image.h"

namespace lightwalk {

/// Pixels of which a channel is NaN, and those (without NaN) of which one is infinite.
struct NonFinite {
    size_t nan = 0, inf = 0;
    size_t total() const { return nan + inf; }
};
NonFinite count_non_finite(const ImageRgb& image);

/// Keeps the relative error finite where the reference is black; linear light squared.
constexpr double relative_epsilon = 0.01;

/// Over all pixels that are finite in both images and their three channels; r is the reference, t the test.
struct Difference {
    double mse = 0;             ///< mean of (t - r)²
    double rmse = 0;            ///< √mse
    double relative_rmse = 0;   ///< √ mean of (t - r)² / (r² + relative_epsilon)
    double max = 0;             ///< max |t - r|
    size_t pixels = 0;          ///< compared; 0 where none is finite in both, and then the means are NaN
    NonFinite reference, test;  ///< left out of the above
};

/// Throws InputError if sizes differ.
Difference difference(const ImageRgb& reference, const ImageRgb& test);

/// 10 log10(peak² / mse) in dB: the mean square, not its root, stands under the logarithm. Infinite where mse is 0.
double psnr_db(double mse, double peak = 1.0);

/// The largest difference of any channel (alpha included) of two 8-bit images, in steps of 1/255, and a pixel that
/// has it.
struct StepDifference {
    int steps = 0, x = 0, y = 0;
    size_t pixels = 0;  ///< that differ at all
};
/// Throws InputError if sizes differ.
StepDifference max_step_difference(const Image8& reference, const Image8& test);

/// True if fewer than `share` of the pixels lie more than `steps` 8-bit steps, in any colour channel, away from the
/// image's median colour: a picture on which nothing was drawn. An image without pixels is constant.
bool is_nearly_constant(const Image8& image, int steps = 4, double share = 0.002);

}  // namespace lightwalk
