// HDR-FLIP's exposures and tone mapper by hand, and the summary of an error map.
#include <cmath>
#include <limits>

#include "catch.h"
#include "common/base/error.h"
#include "common/measure/flip.h"
#include "flip_truth.h"

using namespace lightwalk;

namespace {

/// Narkowicz's fit with the papers' pre-exposure, in double precision.
double tone(double x) {
    x *= 0.6;
    return std::clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

}  // namespace

TEST_CASE("HDR-FLIP's tone mapper: values, limits, inverse") {
    for (const double x : {0.0, 0.01, 0.18, 0.5, 1.0, 3.0, 12.0, 13.0, 1e6})
        CHECK(flip_tone_map(float(x)) == Approx(tone(double(float(x)))).margin(1e-6));
    CHECK(flip_tone_map(-5.0f) == 0.0f);
    CHECK(flip_tone_map(std::numeric_limits<float>::max()) == 1.0f);
    CHECK(tone(flip_tone_map_inverse(0.85)) == Approx(0.85).margin(1e-12));
    CHECK(flip_tone_map_inverse(0.85) > 0.0);
}

TEST_CASE("HDR-FLIP's exposures follow from the brightest and the median luminance") {
    // Greys 1, 4, 64: brightest 64, median 4; at start 64 tone-maps to 0.85, at stop 4 does.
    ImageRgb image(3, 1);
    image.pixels = {glm::vec3(1), glm::vec3(4), glm::vec3(64)};
    const ExposureRange range = automatic_exposures(image);
    CHECK(tone(64 * std::exp2(double(range.start))) == Approx(0.85).margin(1e-5));
    CHECK(tone(4 * std::exp2(double(range.stop))) == Approx(0.85).margin(1e-5));
    CHECK(range.stop - range.start == Approx(4.0).margin(1e-5));  // log2(64 / 4)
    CHECK((range.count == 4 || range.count == 5));                // a rounding apart from ceil(4)
    CHECK(range.at(0) == range.start);
    CHECK(range.at(range.count - 1) == Approx(range.stop).margin(1e-5));
}

TEST_CASE("HDR-FLIP: two exposures at least, one stop apart at most half") {
    CHECK(exposure_range(0, 0).count == 2);
    CHECK(exposure_range(0, 1.5f).count == 2);
    CHECK(exposure_range(0, 2.5f).count == 3);
    CHECK(exposure_range(-3, 4).count == 7);
    CHECK_THROWS_AS(exposure_range(1, 0), InputError);
    CHECK_THROWS_AS(exposure_range(0, std::numeric_limits<float>::infinity()), InputError);
    CHECK_THROWS_AS(exposure_range(0, 1000), InputError);
}

TEST_CASE("HDR-FLIP: a reference that is half black needs explicit exposures") {
    ImageRgb dark(4, 4), test(4, 4, glm::vec3(0.5f));
    dark.at(1, 1) = glm::vec3(9);
    CHECK_THROWS_WITH(automatic_exposures(dark), Catch::Contains("black") && Catch::Contains("exposures explicitly"));
    CHECK_THROWS_AS(flip_hdr(dark, test), InputError);
    for (const float v : flip_hdr(dark, test, exposure_range(-4, 2)).values) CHECK((v > 0.0f && v <= 1.0f));
    ImageRgb nothing(2, 2, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    CHECK_THROWS_AS(automatic_exposures(nothing), InputError);
}

TEST_CASE("HDR-FLIP of constants is the worst exposure's colour difference") {
    const ImageRgb a(3, 3, glm::vec3(0.02f)), b(3, 3, glm::vec3(0.021f));
    // Dark against dark: only the last exposure shows it, so each exposure's factor counts.
    const ExposureRange range = exposure_range(-2, 2.5f);
    double worst = 0;
    for (int i = 0; i < range.count; ++i) {
        const double p = tone(0.02 * std::exp2(double(range.at(i)))), q = tone(0.021 * std::exp2(double(range.at(i))));
        worst = std::max(worst, flip_truth::colour_difference({p, p, p}, {q, q, q}));
    }
    CHECK(flip_hdr(a, b, range).at(1, 1) == Approx(worst).margin(1e-4));
    CHECK(worst > double(flip_ldr(a, b).at(1, 1)));
}

TEST_CASE("HDR-FLIP sees a difference that clamping hides") {
    const ImageRgb a(9, 9, glm::vec3(4)), b(9, 9, glm::vec3(40));
    CHECK(flip_ldr(a, b).at(4, 4) == 0.0f);
    CHECK(flip_hdr(a, b, exposure_range(-6, 0)).at(4, 4) > 0.3f);
}

TEST_CASE("A map's summary: mean, percentiles, percentiles weighed by the error") {
    ErrorMap map{10, 10, std::vector<float>(100, 0.0f)};
    CHECK(summarize(map).weighted_median == 0.0);
    CHECK(summarize(map).max == 0.0);
    map.values[3] = 0.5f;
    map.values[70] = 0.25f;
    map.values[71] = 0.25f;
    const ErrorSummary s = summarize(map);
    CHECK(s.mean == Approx(0.01));
    CHECK(s.max == 0.5);
    CHECK(s.p99 == Approx(0.25 + 0.01 * 0.25));  // rank 98.01 of 0 ... 99
    CHECK(s.weighted_quartile1 == 0.25);         // a quarter of all error has been summed at the first 0.25
    CHECK(s.weighted_median == 0.25);
    CHECK(s.weighted_quartile3 == 0.5);
    CHECK(summarize({}).mean == 0.0);
}

TEST_CASE("The heat map runs from black to pale yellow and grows lighter") {
    CHECK(magma(0.0f) == glm::u8vec3(0, 0, 4));
    CHECK(magma(1.0f) == glm::u8vec3(252, 253, 191));
    CHECK(magma(0.5f) == glm::u8vec3(182, 55, 121));
    CHECK(magma(std::numeric_limits<float>::quiet_NaN()) == magma(0.0f));
    CHECK(magma(7.0f) == magma(1.0f));
    int before = -1;
    for (int i = 0; i <= 64; ++i) {
        const glm::ivec3 c(magma(float(i) / 64.0f));
        const int luma = 2126 * c.r + 7152 * c.g + 722 * c.b;
        CHECK(luma > before);
        before = luma;
    }
    const ErrorMap map{2, 1, {0.0f, 1.0f}};
    CHECK(heat_map(map).at(1, 0) == glm::u8vec4(252, 253, 191, 255));
}
