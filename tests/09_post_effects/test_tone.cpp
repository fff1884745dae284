// Tone curves against their closed forms, and against the reference; and the white point.
#include <fmt/core.h>

#include "09_post_effects/post.h"
#include "09_post_effects/tone_truth.h"
#include "post_fixture.h"

using namespace lightwalk;

namespace {

const char* const curves[] = {"clamp", "reinhard", "film", "narkowicz", "hill", "neutral", "agx", "aces"};

// 10 stops below middle grey to 8 above, in eight hues: grey, and the corners of the cube, a little desaturated.
glm::vec3 chart_light(int x, int y) {
    const glm::vec3 pure((y & 1) ? 1.0f : 0.05f, (y & 2) ? 1.0f : 0.05f, (y & 4) ? 1.0f : 0.05f);
    return (y == 0 ? glm::vec3(1) : pure) * 0.18f * std::exp2(float(x) * 0.25f - 10.0f);
}

double code(double light) { return 255 * truth::encode_srgb(light); }

}  // namespace

TEST_CASE_METHOD(OnPost, "every curve on the device is its closed form in double precision") {
    const ImageRgb light = shown({73, 8}, chart_light);
    for (const char* const curve : curves) {
        post.tone.set(curve);
        const ImageRgb found = shown({73, 8}, chart_light);
        double worst = 0;
        for (size_t i = 0; i < found.pixels.size(); ++i) {
            const glm::dvec3 exact = truth::tone(curve, glm::dvec3(light.pixels[i]));
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::fabs(code(double(found.pixels[i][c])) - code(exact[c])));
        }
        INFO(curve);
        CHECK(worst < 0.3);  // of an 8-bit code: a half float is up to 0.1 away, a logarithm the rest
    }
}

TEST_CASE("the reference: middle grey is 10 percent, white is white, and no colour leaves the screen") {
    const glm::dvec3 grey = truth::reference_tone(glm::dvec3(0.18));
    // 4.8 nits of 48, less the screen's black, brighter in dim surround: (0.0996)^0.9811.
    CHECK(grey.g == Approx(0.104).epsilon(0.005));
    CHECK(grey.r == Approx(grey.g).epsilon(1e-3));
    CHECK(grey.b == Approx(grey.g).epsilon(1e-3));
    CHECK(truth::reference_tone(glm::dvec3(1000)).g == Approx(1).epsilon(0.02));
    CHECK(truth::reference_tone(glm::dvec3(0)).g < 1e-6);
    double last = -1;
    for (double stops = -12; stops < 12; stops += 0.05) {
        const double now = truth::reference_tone(glm::dvec3(0.18 * std::exp2(stops))).g;
        CHECK(now >= last);
        last = now;
    }
}

TEST_CASE("curves at equal middle grey against the reference, in codes", "[figures][09.curves]") {
    for (const char* const curve : curves) {
        const double gain = matching_gain(curve);
        double grey = 0, sum = 0, most = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 73; ++x) {
                const glm::dvec3 light(chart_light(x, y));
                const glm::dvec3 found = truth::tone(curve, gain * light), exact = truth::reference_tone(light);
                for (int c = 0; c < 3; ++c) {
                    const double off = std::fabs(code(found[c]) - code(exact[c]));
                    sum += off / (8 * 73 * 3);
                    most = std::max(most, off);
                    if (y == 0) grey = std::max(grey, off);
                }
            }
        fmt::print(
            "{:10} gain {:.3f}: greys at most {:5.1f} codes off, colours {:5.1f} in the mean and {:5.1f} at most\n",
            curve, gain, grey, sum, most);
        CHECK(code(truth::tone(curve, glm::dvec3(0.18 * gain)).g) ==
              Approx(code(truth::reference_tone(glm::dvec3(0.18)).g)).margin(0.5));
        if (std::string(curve) == "aces") CHECK(most == 0);
        if (std::string(curve) == "hill") CHECK(grey < 12);
    }
}

TEST_CASE("Narkowicz's fit of grey, at the exposure at which it fits best", "[figures]") {
    double least = 1, at = 0;
    for (double gain = 0.4; gain < 0.9; gain += 0.005) {
        double most = 0;
        for (double x = 0; x < 8; x += 0.02)
            most = std::max(
                most, std::fabs(std::min(truth::narkowicz(gain * x), 1.0) - truth::reference_tone(glm::dvec3(x)).g));
        if (most < least) {
            least = most;
            at = gain;
        }
    }
    fmt::print("narkowicz at {:.3f} of the light: at most {:.4f} from the reference's greys, in linear light\n", at,
               least);
    CHECK(least < 0.03);
    CHECK(truth::narkowicz(7.24) == Approx(1).epsilon(1e-3));  // from there on it clips
}

TEST_CASE("white: daylight of 6504 K changes nothing; what was white by another daylight becomes grey") {
    CHECK(white_balance_matrix(6504) == glm::mat3(1.0f));
    for (const double kelvin : {4000.0, 5003.0, 9300.0, 25000.0}) {
        const glm::mat3 matrix = white_balance_matrix(kelvin);
        const glm::vec3 white = matrix * glm::vec3(1);
        INFO(kelvin);
        CHECK((kelvin < 6504 ? white.b > white.r : white.r > white.b));  // warm light is answered by blue
        // Back and forth: the inverse is the way from the other white.
        CHECK(std::fabs(double(glm::determinant(matrix)) - 1) < 0.9);
    }
    // Illuminant D50 is (0.3457, 0.3585): under it a white card has that colour, and must come out grey.
    const glm::dmat3 rgb = truth::rec709_to_xyz();
    const glm::vec3 card(glm::inverse(rgb) * truth::xyz_of({0.3457, 0.3585}));
    const glm::vec3 balanced = white_balance_matrix(5003) * card;
    CHECK(double(balanced.r) == Approx(double(balanced.g)).epsilon(0.01));
    CHECK(double(balanced.b) == Approx(double(balanced.g)).epsilon(0.01));
}
