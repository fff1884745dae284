// FLIP against values derived by hand from the papers, and against a brute-force double-precision version. The
// authors publish the means of one image pair (LDR 0.159691, HDR 0.283478); the images are not in this repository, so
// those two figures are not checked here.
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "common/base/error.h"
#include "common/measure/flip.h"
#include "flip_truth.h"

using namespace lightwalk;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

ImageRgb noise(int width, int height, unsigned seed, float largest = 1.0f) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, largest);
    ImageRgb image(width, height);
    for (glm::vec3& p : image.pixels) p = {value(random), value(random), value(random)};
    return image;
}

float constant_flip(glm::vec3 a, glm::vec3 b) { return flip_ldr(ImageRgb(5, 4, a), ImageRgb(5, 4, b)).at(2, 2); }

double truth_of_constants(glm::vec3 a, glm::vec3 b) {
    return flip_truth::colour_difference({a.x, a.y, a.z}, {b.x, b.y, b.z});
}

double worst_against_truth(const ImageRgb& a, const ImageRgb& b, float per_degree) {
    const ErrorMap map = flip_ldr(a, b, per_degree);
    const auto truth = flip_truth::flip(a, b, double(per_degree));
    double worst = 0;
    for (size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, std::abs(truth[i] - double(map.values[i])));
    return worst;
}

}  // namespace

TEST_CASE("FLIP of an image with itself is exactly 0") {
    const ImageRgb image = noise(37, 23, 1);
    for (const float v : flip_ldr(image, image).values) REQUIRE(v == 0.0f);
    for (const float v : flip_hdr(image, image).values) REQUIRE(v == 0.0f);
}

TEST_CASE("FLIP of constant images is the redistributed colour difference") {
    // Filters leave a constant as it is and no feature is found, so only section 4.1.3 is left.
    // Black against white by hand: HyAB is 100; green to blue is the largest, 308.97 in double precision.
    const double largest = flip_truth::hyab(flip_truth::hunt_lab({0, 1, 0}), flip_truth::hunt_lab({0, 0, 1}));
    const double c_max = std::pow(largest, 0.7), knee = 0.4 * c_max, black_white = std::pow(100.0, 0.7);
    REQUIRE(black_white > knee);
    const double by_hand = 0.95 + 0.05 * (black_white - knee) / (c_max - knee);
    CHECK(constant_flip(glm::vec3(0), glm::vec3(1)) == Approx(by_hand).margin(1e-5));
    CHECK(by_hand == Approx(0.97).margin(0.01));  // not 1: green against blue is further apart than black and white
    CHECK(constant_flip({0, 1, 0}, {0, 0, 1}) == Approx(1.0).margin(1e-5));

    const std::vector<glm::vec3> colours = {{0, 0, 0},       {1, 1, 1},          {1, 0, 0},         {0, 1, 0},
                                            {0, 0, 1},       {.5f, .5f, .5f},    {.18f, .2f, .16f}, {.5f, .502f, .5f},
                                            {.9f, .1f, .4f}, {.001f, .002f, .0f}};
    for (const glm::vec3& a : colours)
        for (const glm::vec3& b : colours) {
            INFO("(" << a.x << " " << a.y << " " << a.z << ") against (" << b.x << " " << b.y << " " << b.z << ")");
            // d^0.7 has no bound on its slope at 0, so that the tolerance is one of single precision there.
            CHECK(constant_flip(a, b) == Approx(truth_of_constants(a, b)).margin(3e-5));
        }
}

TEST_CASE("FLIP agrees with a brute-force convolution in double precision") {
    ImageRgb edge_a(24, 20, glm::vec3(.2f)), edge_b = edge_a, point = edge_a, line = edge_a;
    for (int y = 0; y < 20; ++y)
        for (int x = 12; x < 24; ++x) edge_a.at(x, y) = {.7f, .6f, .5f};
    for (int y = 0; y < 20; ++y)
        for (int x = 14; x < 24; ++x) edge_b.at(x, y) = {.7f, .6f, .5f};
    point.at(9, 11) = {1, 1, 1};
    for (int x = 0; x < 24; ++x) line.at(x, 0) = {0, .9f, .1f};
    for (const float per_degree : {67.0206f, 25.0f, 8.0f}) {
        INFO("pixels per degree " << per_degree);
        // At 8 a neighbour's colour weighs 1e-8, below single precision, where the feature's exponent (0.26 here)
        // would still make 0.003 of it.
        const double tolerance = per_degree > 10.0f ? 2e-4 : 5e-3;
        CHECK(worst_against_truth(edge_a, edge_b, per_degree) < tolerance);
        CHECK(worst_against_truth(edge_a, ImageRgb(24, 20, glm::vec3(.2f)), per_degree) < tolerance);
        CHECK(worst_against_truth(ImageRgb(24, 20, glm::vec3(.2f)), point, per_degree) < tolerance);
        CHECK(worst_against_truth(point, line, per_degree) < tolerance);
        CHECK(worst_against_truth(noise(13, 11, 3), noise(13, 11, 4), per_degree) < tolerance);
    }
    CHECK(worst_against_truth(noise(1, 1, 3), noise(1, 1, 4), 67.0f) < 2e-4);
    CHECK(worst_against_truth(noise(1, 40, 3), noise(1, 40, 4), 67.0f) < 2e-4);
    CHECK(worst_against_truth(noise(33, 1, 3), noise(33, 1, 4), 67.0f) < 2e-4);
}

TEST_CASE("FLIP is symmetric bit for bit and lies in [0, 1]") {
    for (const auto& [width, height] : {std::pair(50, 41), std::pair(1, 1), std::pair(3, 70), std::pair(64, 2)}) {
        ImageRgb a = noise(width, height, 5), b = noise(width, height, 6);
        for (size_t i = 0; i < a.pixels.size(); i += 3) a.pixels[i] = glm::vec3(float(i % 2));
        const ErrorMap ab = flip_ldr(a, b), ba = flip_ldr(b, a);
        CHECK(ab.values == ba.values);
        for (const float v : ab.values) CHECK((v >= 0.0f && v <= 1.0f));
        CHECK(flip_hdr(a, b, exposure_range(-2, 3)).values == flip_hdr(b, a, exposure_range(-2, 3)).values);
    }
}

TEST_CASE("pixels per degree: the papers' screen gives 67.0206") {
    CHECK(pixels_per_degree(0.7f, 0.7f, 3840) == Approx(67.0206).margin(1e-4));
    CHECK(default_pixels_per_degree == pixels_per_degree(0.7f, 0.7f, 3840));
    CHECK(pixels_per_degree(1.4f, 0.7f, 3840) == Approx(2 * 67.0206).margin(1e-3));
}

TEST_CASE("FLIP: NaN and Inf are errors of their own pixels only") {
    const ImageRgb a = noise(30, 30, 7);
    for (const float bad : {nan_value, infinite, -infinite}) {
        ImageRgb b = a;
        b.at(10, 12).y = bad;
        for (const auto& map : {flip_ldr(a, b), flip_ldr(b, a), flip_hdr(a, b), flip_hdr(b, a)})
            for (int y = 0; y < 30; ++y)
                for (int x = 0; x < 30; ++x) REQUIRE(map.at(x, y) == (x == 10 && y == 12 ? 1.0f : 0.0f));
    }
}

TEST_CASE("LDR-FLIP clamps what lies outside [0, 1]") {
    const ImageRgb inside = noise(20, 20, 8);
    ImageRgb clamped = inside, outside = inside;
    clamped.at(9, 9) = {1, 0, 1};
    outside.at(9, 9) = {50, -2, 1};
    CHECK(flip_ldr(clamped, outside).values == flip_ldr(inside, inside).values);
    CHECK(flip_ldr(outside, inside).values == flip_ldr(clamped, inside).values);
    CHECK(flip_ldr(inside, outside).values == flip_ldr(inside, clamped).values);
}

TEST_CASE("FLIP refuses what it cannot compare") {
    CHECK_THROWS_AS(flip_ldr(ImageRgb(3, 4), ImageRgb(4, 3)), InputError);
    CHECK_THROWS_AS(flip_ldr(ImageRgb(), ImageRgb()), InputError);
    CHECK_THROWS_AS(flip_ldr(ImageRgb(2, 2), ImageRgb(2, 2), 0.0f), InputError);
    CHECK_THROWS_AS(flip_ldr(ImageRgb(2, 2), ImageRgb(2, 2), nan_value), InputError);
}

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
