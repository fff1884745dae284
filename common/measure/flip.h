// FLIP: perceived difference between two alternating images, per pixel in [0, 1].
//
// LDR: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for
//      Alternating Images", Proc. ACM CGIT (HPG) 3(2), 2020.
// HDR: Andersson, Nilsson, Shirley, Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images",
//      Eurographics Short Papers, 2021.
#pragma once
#include <optional>
#include <vector>

#include "common/image/image.h"

namespace lightwalk {

/// Pixels per degree of visual angle: distance · pixels / width · pi / 180.
float pixels_per_degree(float distance_m, float width_m, float width_pixels);

/// The papers' default: a 0.7 m wide screen with 3840 pixels at 0.7 m, 3840 · pi / 180 = 67.0206.
constexpr float default_pixels_per_degree = 67.020643f;

/// Error per pixel in [0, 1], rows from the top.
struct ErrorMap {
    int width = 0, height = 0;
    std::vector<float> values;

    float at(int x, int y) const { return values[size_t(y) * size_t(width) + size_t(x)]; }
};

/// LDR-FLIP of linear images, clamped to [0, 1]; symmetric. Non-finite pixels have error 1 and do not affect
/// neighbours. Throws InputError: different sizes, empty image, pixels_per_degree outside (0, 1000].
ErrorMap flip_ldr(const ImageRgb& reference, const ImageRgb& test, float pixels_per_degree = default_pixels_per_degree);

/// `count` exposures in stops (log2 of the factor), evenly spaced.
struct ExposureRange {
    float start = 0.0f, stop = 0.0f;
    int count = 2;

    float at(int i) const { return count < 2 ? start : start + float(i) * (stop - start) / float(count - 1); }
};

/// max(2, ceil(stop - start)) exposures, as in the 2021 paper. Throws InputError: not finite, start > stop, > 64 stops.
ExposureRange exposure_range(float start, float stop);

/// Range of the 2021 paper, from maximum to median luminance of finite pixels. Throws InputError if the median is 0.
ExposureRange automatic_exposures(const ImageRgb& reference);

/// ACES fit by K. Narkowicz, https://knarkowicz.wordpress.com/2016/01/06/, with pre-exposure 0.6 as in the 2021 paper's
/// supplement: y = 0.6 x, (2.51 y² + 0.03 y) / (2.43 y² + 0.59 y + 0.14). Linear to linear, clamped to [0, 1].
float flip_tone_map(float linear);

/// Smallest linear value that flip_tone_map() maps to `level`, in (0, 1).
double flip_tone_map_inverse(double level);

/// HDR-FLIP: per-pixel maximum of LDR-FLIP over the exposures. Default: automatic_exposures(reference), which makes the
/// result asymmetric. Values are clamped to [0, 65536]; non-finite pixels have error 1. Throws InputError.
ErrorMap flip_hdr(const ImageRgb& reference, const ImageRgb& test, std::optional<ExposureRange> exposures = {},
                  float pixels_per_degree = default_pixels_per_degree);

/// Percentiles are weighted by error (2020, section 6): half of the error is at or above the weighted median.
struct ErrorSummary {
    double mean = 0, p99 = 0, max = 0;
    double weighted_quartile1 = 0, weighted_median = 0, weighted_quartile3 = 0;
};
ErrorSummary summarize(const ErrorMap& map);

/// Magma colour map as sRGB (van der Walt and Smith, CC0, https://bids.github.io/colormap/), from black (0) to pale
/// yellow (1): linear between 17 control points, within 3 of 255 steps of the original.
glm::u8vec3 magma(float value);
Image8 heat_map(const ErrorMap& map);

namespace detail {
/// CIE XYZ from linear Rec. 709 RGB; white point D65 (0.31271, 0.32902), Y = 1.
glm::dmat3 rgb_to_xyz();
}  // namespace detail

}  // namespace lightwalk
