// FLIP: how visible the difference between two images is to a person who flips between them, per pixel in [0, 1].
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

/// Pixels per degree of visual angle at `distance_m` from a screen `width_m` wide that shows `width_pixels`:
/// distance * pixels / width * pi / 180.
float pixels_per_degree(float distance_m, float width_m, float width_pixels);

/// A 3840-pixel screen of 0.7 m seen from 0.7 m, the papers' default: 3840 * pi / 180 = 67.0206.
constexpr float default_pixels_per_degree = 67.020643f;

/// The error per pixel, rows from the top.
struct ErrorMap {
    int width = 0, height = 0;
    std::vector<float> values;

    float at(int x, int y) const { return values[size_t(y) * size_t(width) + size_t(x)]; }
};

/// LDR-FLIP of linear-light images in [0, 1] (values outside are clamped). flip(a, b) equals flip(b, a) bit for bit.
/// A pixel that is NaN or infinite in either image gets error 1 and does not touch its neighbours' error.
/// Throws InputError if sizes differ or an image is empty, or pixels_per_degree is not in (0, 1000].
ErrorMap flip_ldr(const ImageRgb& reference, const ImageRgb& test, float pixels_per_degree = default_pixels_per_degree);

/// The exposures HDR-FLIP looks at, in stops (log2 of the factor), `count` of them evenly from start to stop.
struct ExposureRange {
    float start = 0.0f, stop = 0.0f;
    int count = 2;

    float at(int i) const { return count < 2 ? start : start + float(i) * (stop - start) / float(count - 1); }
};

/// From `start` to `stop` with the 2021 paper's count, max(2, ceil(stop - start)). Throws InputError unless both are
/// finite, start <= stop, and the range is at most 64 stops.
ExposureRange exposure_range(float start, float stop);

/// The 2021 paper's range: at `start` the reference's brightest luminance, at `stop` its median luminance, tone-maps
/// to 0.85. Pixels that are NaN or infinite are left out.
/// Throws InputError if the median is 0 (more than half of it is black: log2(max / 0) is infinite).
ExposureRange automatic_exposures(const ImageRgb& reference);

/// The tone mapper HDR-FLIP assumes: Narkowicz's ACES fit, https://knarkowicz.wordpress.com/2016/01/06/, with its
/// pre-exposure 0.6 folded in as in the 2021 paper's supplement: y = 0.6 x, (2.51 y² + 0.03 y)/(2.43 y² + 0.59 y +
/// 0.14). Linear in, linear out, clamped to [0, 1].
float flip_tone_map(float linear);

/// The least linear value that flip_tone_map takes to `level`, in (0, 1).
double flip_tone_map_inverse(double level);

/// HDR-FLIP: the largest LDR-FLIP over the exposures, per pixel. Values are clamped to [0, 65536], NaN and Inf as in
/// flip_ldr. Without `exposures` the reference decides; the result is then not symmetric. Throws as the above do.
ErrorMap flip_hdr(const ImageRgb& reference, const ImageRgb& test, std::optional<ExposureRange> exposures = {},
                  float pixels_per_degree = default_pixels_per_degree);

/// Summary of an error map. Weighted percentiles (2020, section 6) weigh each pixel by its error: half of the total
/// error lies in pixels at or above the weighted median.
struct ErrorSummary {
    double mean = 0, p99 = 0, max = 0;
    double weighted_quartile1 = 0, weighted_median = 0, weighted_quartile3 = 0;
};
ErrorSummary summarize(const ErrorMap& map);

/// The magma colour map, perceptually uniform from black (0) to pale yellow (1); van der Walt and Smith, CC0,
/// https://bids.github.io/colormap/. Linear between 17 control points, within 3 of 255 steps of it. sRGB.
glm::u8vec3 magma(float value);
Image8 heat_map(const ErrorMap& map);

namespace detail {
/// CIE XYZ of linear Rec. 709 RGB with white at D65 (0.31271, 0.32902), Y of white 1.
glm::dmat3 rgb_to_xyz();
}  // namespace detail

}  // namespace lightwalk
