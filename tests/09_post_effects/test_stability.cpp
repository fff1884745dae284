// Where effects go wrong: a bound where they hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <limits>
#include <random>
#include <set>

#include "09_post_effects/post.h"
#include "09_post_effects/tone_truth.h"
#include "post_fixture.h"

using namespace lightwalk;

namespace {

// Half floats: 2^-11 of the value, twice that where a store cuts off; and functions of a device.
double half_step(double value) { return 1.5e-3 * std::fabs(value) + 2e-5; }

const char* const ways_on[] = {"on", "fixed", "hill", "white", "bayer_8"};

void switch_on(KnobBase& effect) {
    for (const char* way : ways_on) {
        try {
            effect.set(way);
            return;
        } catch (const InputError&) { continue; }
    }
    FAIL(effect.name << " cannot be switched on");
}

}  // namespace

TEST_CASE_METHOD(OnPost, "fused and one pass each are the same to the last bit: each effect alone, each pair, all",
                 "[09.fused]") {
    post.stops.value = 0.7f;
    post.gamma_by.value = 1.3f;
    post.white_k.value = 5200;
    const auto same = [&](const std::string& what) {
        post.method.set("fused");
        const ImageRgb fused = shown({70, 9}, motley, 3.5f);
        post.method.set("pass_each");
        const ImageRgb each = shown({70, 9}, motley, 3.5f);
        INFO(what);
        CHECK(is_finite(fused));
        CHECK(identical(fused, each));
    };
    same("none");
    const std::vector<KnobBase*> all = post.effects();
    for (size_t i = 0; i < all.size(); ++i) {
        switch_off();
        switch_on(*all[i]);
        same(all[i]->name);
        switch_on(*all[(i + 1) % all.size()]);
        same(all[i]->name + " and the next");
    }
    for (KnobBase* effect : all) switch_on(*effect);
    same("all");
    post.exposure.set("automatic");
    post.tone.set("agx");
    post.grain.set("texture");
    post.dither.set("blue_noise");
    same("all, in other ways");
}

TEST_CASE_METHOD(OnPost, "with half floats between the passes the pictures differ, and how far",
                 "[figures][09.half_floats]") {
    for (KnobBase* effect : post.effects()) switch_on(*effect);
    post.dither.set("off");
    const ImageRgb fused = shown({70, 40}, motley);
    post.method.set("pass_each");
    post.store.set("half");
    const double off = largest_difference(shown({70, 40}, motley), fused);
    fmt::print("16 effects, half floats between them: at most {:.4f} away\n", off);
    CHECK(off > 0);
    CHECK(off < 0.1);
}

TEST_CASE_METHOD(OnPost, "passes: one for all that need their pixel alone, one for each that looks at others") {
    const auto passes = [&] {
        shown({8, 8}, motley);
        std::vector<std::string> names;
        for (const PassTime& time : frame.times)
            if (time.stage == "compute") names.push_back(time.name);
        return names;
    };
    CHECK(passes().empty());
    post.vignette.set("on");
    post.tone.set("agx");
    CHECK(passes() == std::vector<std::string>{"post"});
    post.sharpen.set("on");
    post.aberration.set("on");
    CHECK(passes() == std::vector<std::string>{"post.aberration", "post.sharpen", "post"});
    post.method.set("pass_each");
    CHECK(passes() == std::vector<std::string>{"post.aberration", "post.sharpen", "post.tone", "post.vignette"});
    post.method.set("copy");
    CHECK(passes() == std::vector<std::string>{"post"});
    CHECK(identical(shown({8, 8}, motley), read_linear(gpu, hdr)));
}

TEST_CASE_METHOD(OnPost, "off and neutral change nothing; each effect is its closed form") {
    const ImageRgb plain = shown({70, 9}, motley);
    const auto compare = [&](const std::string& what, const auto& form, double steps = 1) {
        const ImageRgb found = shown({70, 9}, motley);
        double worst = 0;
        for (size_t i = 0; i < plain.pixels.size(); ++i) {
            const glm::dvec3 wanted = form(glm::dvec3(plain.pixels[i]));
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::fabs(double(found.pixels[i][c]) - wanted[c]) / half_step(wanted[c]));
        }
        INFO(what);
        CHECK(worst < steps);
        switch_off();
    };
    using glm::dvec3;
    post.exposure.set("fixed");
    post.stops.value = 0;
    compare("exposure of 0 stops", [](dvec3 c) { return c; });
    post.exposure.set("fixed");
    post.stops.value = -1.5f;
    compare("exposure", [](dvec3 c) { return c * std::exp2(-1.5); });
    post.white_balance.set("on");
    post.white_k.value = 6504;
    compare("white balance of daylight", [](dvec3 c) { return c; });
    post.contrast.set("on");
    post.contrast_by.value = 1;
    compare("contrast of 1", [](dvec3 c) { return c; });
    post.contrast.set("on");
    post.contrast_by.value = 1.7f;
    compare("contrast", [](dvec3 c) { return truth::contrast(c, double(1.7f)); });
    post.saturation.set("on");
    post.saturation_by.value = 0.3f;
    compare("saturation", [](dvec3 c) { return truth::saturate_color(c, double(0.3f)); });
    post.brightness.set("on");
    post.brightness_by.value = -0.5f;
    compare("brightness", [](dvec3 c) { return glm::max(c - 0.5, dvec3(0)); });
    post.greyscale.set("on");
    post.greyscale_by.value = 1;
    compare("greyscale", [](dvec3 c) { return dvec3(truth::luminance_of(c)); });
    post.invert.set("on");
    post.invert_by.value = 1;
    compare("invert", [](dvec3 c) { return 1.0 - glm::clamp(c, 0.0, 1.0); });
    post.fade.set("on");
    post.fade_by.value = 1;
    post.fade_color.value = {0.5f, 0.25f, 1};
    compare("fade to a colour", [](dvec3) { return dvec3(0.5, 0.25, 1); });
    post.gamma.set("on");
    post.gamma_by.value = 2.2f;
    compare("gamma", [](dvec3 c) { return truth::apply_gamma(c, double(2.2f)); });
    post.scanlines.set("on");
    post.scan_strength.value = 0;
    compare("scanlines of no strength", [](dvec3 c) { return c; });
    post.vignette.set("on");
    post.vignette_strength.value = 0;
    compare("a vignette of no strength", [](dvec3 c) { return c; });
    post.sharpen.set("on");
    post.sharpen_by.value = 0;
    compare("a kernel of no strength", [](dvec3 c) { return c; });
    post.aberration.set("on");
    post.aberration_shift.value = glm::vec3(0);
    compare(
        "an aberration of no shift", [](dvec3 c) { return c; }, 3);  // filters weigh with 8 bits
    post.radial_blur.set("on");
    post.blur_by.value = 0;
    compare(
        "a radial blur of no way", [](dvec3 c) { return c; }, 3);  // filters weigh with 8 bits
}

TEST_CASE_METHOD(OnPost, "the middle of the picture: no direction, no NaN, and it stays", "[09.middle]") {
    post.vignette.set("on");
    post.aberration.set("on");
    for (const float power : {0.0f, 0.1f, 8.0f})
        for (const float shift : {-0.2f, 0.2f}) {
            post.vignette_power.value = power;
            post.aberration_shift.value = glm::vec3(shift);
            const ImageRgb found = shown({5, 5}, [](int x, int y) { return x == 2 && y == 2 ? 1.0f : 0.0f; });
            CHECK(is_finite(found));
            // A quotient may be off by 2.5 ulp, and so may the middle, 0.5; a power below 1 enlarges that.
            const double away = std::pow(2.5 * 0x1p-24 / std::sqrt(0.5), double(power)),
                         middle = double(found.at(2, 2).g);
            CHECK(middle >= 0.99 * (1 - 0.5 * away));
            CHECK(middle <= (power == 0 ? 0.505 : 1.01));
        }
}

TEST_CASE_METHOD(OnPost, "nothing is read off the screen: what lies behind the border is never the border smeared") {
    // A bright frame of one pixel around the picture: read outside, it would be as wide as the shift.
    const auto framed = [](int x, int y) { return x == 0 || y == 0 || x == 199 || y == 99 ? 1.0f : 0.0f; };
    post.aberration.set("on");
    for (const float shift : {0.2f, 0.05f}) {
        post.aberration_shift.value = glm::vec3(shift);
        const ImageRgb found = shown({200, 100}, framed);
        int wide = 0;
        for (int x = 0; x < 100; ++x) wide += found.at(x, 2).g > 0.5f;
        CHECK(wide <= 2);  // at most the column of the frame, a little enlarged
        CHECK(found.at(0, 0).g > 0.2f);
    }
}

TEST_CASE_METHOD(OnPost, "Hill's curve is below 0 for black: unclamped a power of it is NaN; here it is 0",
                 "[09.hill]") {
    const double black = truth::hill(glm::dvec3(0), false).g;
    CHECK(black == Approx(-3.8e-4).epsilon(0.01));
    CHECK(std::isnan(std::pow(black, 1 / 2.2)));
    post.tone.set("hill");
    post.gamma.set("on");
    post.gamma_by.value = 2.2f;
    const ImageRgb found = shown({4, 4}, all_of(glm::vec3(0)));
    CHECK(is_finite(found));
    CHECK(mean(found) == glm::dvec3(0));
    CHECK(truth::narkowicz(7.24) == Approx(1).epsilon(1e-3));  // from there on it clips
    CHECK(truth::narkowicz(7.0) < 1);
}

TEST_CASE_METHOD(OnPost, "infinity, NaN and 65504: finite with every curve, and no neighbour is touched") {
    const float inf = std::numeric_limits<float>::infinity();
    for (const std::string& curve : post.tone.options) {
        if (curve == "off") continue;
        post.tone.set(curve);
        const auto with = [&](float bad) {
            return shown({8, 4},
                         [&](int x, int y) { return x == 3 && y == 2 ? glm::vec3(bad, 1, 0) : glm::vec3(0.5f); });
        };
        const ImageRgb plain = with(0.5f);
        for (const float bad : {inf, -inf, std::nanf(""), 65504.0f, -1.0f}) {
            ImageRgb found = with(bad);
            INFO(curve << " " << bad);
            CHECK(is_finite(found));
            for (const glm::vec3& c : found.pixels) CHECK((c.r >= 0 && c.r <= 1 && c.g <= 1 && c.b >= 0));
            found.at(3, 2) = plain.at(3, 2);
            CHECK(identical(found, plain));
        }
    }
}

TEST_CASE_METHOD(OnPost, "grain at a time of a million seconds is as good as at the first; of a sine it is not",
                 "[figures][09.late_grain]") {
    post.grain.set("white");
    post.grain_by.value = 0.25f;
    const auto spread = [&](const ImageRgb& picture) {
        const double middle = mean(picture).g;
        double square = 0;
        for (const glm::vec3& c : picture.pixels) square += std::pow(double(c.g) - middle, 2);
        return std::sqrt(square / double(picture.pixels.size()));
    };
    const auto grey = all_of(glm::vec3(0.214f));  // code 0.5
    const ImageRgb first = shown({64, 64}, grey, 0.1f), late = shown({64, 64}, grey, 1e6f);
    CHECK(spread(late) == Approx(spread(first)).epsilon(0.05));
    CHECK(!identical(first, late));
    CHECK(!identical(late, shown({64, 64}, grey, 1e6f + 0.125f)));  // a float counts sixteenths of a second there
    CHECK(identical(late, shown({64, 64}, grey, 1e6f)));
    // fract(sin(12.9898 x + 78.233 y + frame) * 43758.5453) in floats, at 24 pictures a second: a float counts by twos
    // there.
    std::set<float> values;
    for (int picture = 0; picture < 64; ++picture) {
        const float at = std::sin(12.9898f * 7 + 78.233f * 3 + float(24000000 + picture)) * 43758.5453f;
        values.insert(at - std::floor(at));
    }
    fmt::print("64 pictures of grain from a sine, after a million seconds: {} different ones\n", values.size());
    CHECK(values.size() < 35);
}

TEST_CASE_METHOD(OnPost,
                 "dither: the mean is what was asked for, and a gradient of less than a code in 8 pixels has no bands",
                 "[figures][09.dither_mean]") {
    // From code 100 to 104 over 64 pixels: less than one code in 8.
    const auto slope = [](int x, int) { return float(truth::decode_srgb((100.0 + 4.0 * x / 64) / 255)); };
    for (const std::string& kind : post.dither.options) {
        post.dither.set(kind);
        const ImageRgb found = shown({64, 64}, slope);
        double worst = 0, sum = 0;  // of the mean over columns of 8; over all
        for (int x = 0; x < 64; x += 8) {
            double codes = 0, wanted = 0;
            for (int i = 0; i < 8; ++i)
                for (int y = 0; y < 64; ++y) {
                    const double code = 255 * truth::encode_srgb(double(found.at(x + i, y).g));
                    codes += (kind == "off" ? std::round(code) : code) / 512;
                    wanted += (100.0 + 4.0 * (x + i) / 64) / 512;
                }
            worst = std::max(worst, std::fabs(codes - wanted));
            sum += (codes - wanted) / 8;
        }
        fmt::print("dither {:10}: the mean of 8 columns is {:.3f} codes off, of all {:+.3f}\n", kind, worst, sum);
        if (kind == "off") {
            CHECK(worst > 0.2);  // half a code in the worst places
        } else {
            CHECK(std::fabs(sum) < 0.04);  // and 16 thresholds are a 32nd of a code apart; half floats 0.05
            CHECK(worst < 0.1);
            // The stored value is a code: encoding it again gives the same one.
            for (const glm::vec3& c : found.pixels) {
                const double code = 255 * truth::encode_srgb(double(c.g));
                CHECK(std::fabs(code - std::round(code)) < 0.15);
            }
        }
    }
}

TEST_CASE("blue noise: each threshold once, and its points keep apart") {
    const std::vector<float> tile = blue_noise(32);
    std::vector<float> sorted = tile;
    std::sort(sorted.begin(), sorted.end());
    for (size_t i = 0; i < sorted.size(); ++i) CHECK(sorted[i] == (float(i) + 0.5f) / 1024.0f);
    // The tenth with the lowest thresholds: the mean distance to the nearest other, against as many at random.
    const auto apart = [](const std::vector<std::pair<int, int>>& points) {
        double sum = 0;
        for (const auto& [x, y] : points) {
            double nearest = 1e9;
            for (const auto& [u, v] : points) {
                const int dx = std::abs(x - u), dy = std::abs(y - v);
                if (dx + dy > 0) nearest = std::min(nearest, std::hypot(std::min(dx, 32 - dx), std::min(dy, 32 - dy)));
            }
            sum += nearest / double(points.size());
        }
        return sum;
    };
    std::vector<std::pair<int, int>> lowest, random;
    std::mt19937 engine(3);
    for (int i = 0; i < 1024; ++i)
        if (tile[size_t(i)] < 0.1f) {
            lowest.emplace_back(i % 32, i / 32);
            random.emplace_back(engine() % 32, engine() % 32);
        }
    CHECK(apart(lowest) > 2.4);
    CHECK(apart(random) < 1.9);
}

TEST_CASE_METHOD(OnPost,
                 "automatic exposure: middle grey in one frame; a flash is followed in the stated time, not faster",
                 "[09.exposure]") {
    post.exposure.set("automatic");
    post.automatic.adapt_s.value = 0.5f;
    const auto exposed = [&](float light, float time_s) {
        return mean(shown({64, 36}, all_of(glm::vec3(light)), time_s)).g;
    };
    CHECK(exposed(0.02f, 0) == Approx(0.18).epsilon(0.04));  // a bin is 0.094 stops wide
    const double before = std::log2(exposed(0.02f, 0.1f) / double(0.02f));
    // The light is 32 times as bright from now on: 5 stops. After adapt_s 63% of them are followed.
    for (int i = 1; i <= 30; ++i) {
        const double time_s = i / 60.0, stops = std::log2(exposed(0.64f, 0.1f + float(time_s)) / double(0.64f));
        const double followed = (before - stops) / 5;
        CHECK(followed == Approx(1 - std::exp(-time_s / 0.5)).margin(0.02));
    }
    for (int i = 31; i <= 240; ++i) exposed(0.64f, 0.1f + float(i) / 60.0f);
    CHECK(exposed(0.64f, 4.2f) == Approx(0.18).epsilon(0.04));
    // Black gives no message, and a non-finite value exactly one.
    post.tone.set("clamp");
    CHECK(is_finite(shown({64, 36}, all_of(glm::vec3(0)), 4.3f)));
    CHECK(is_finite(shown(
        {64, 36}, [](int x, int y) { return x + y == 7 ? std::nanf("") : 0.2f; }, 9.0f)));
}

TEST_CASE_METHOD(OnPost, "the histogram counts every pixel once, whatever the size") {
    post.exposure.set("automatic");
    for (const glm::uvec2 size : {glm::uvec2{1, 1}, {17, 3}, {64, 64}, {333, 7}}) {
        shown(size, motley);
        uint32_t all = 0;
        for (const uint32_t n : OnDevice::numbers<uint32_t>(gpu.read_back(post.automatic.bins()))) all += n;
        CHECK(all == size.x * size.y);
    }
}
