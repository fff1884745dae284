// Where blooms go wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <limits>

#include "08_bloom/truth.h"
#include "bloom_fixture.h"

using namespace lightwalk;

namespace {

float noise(int x, int y) {
    uint32_t n = (uint32_t(x) * 73856093u) ^ (uint32_t(y) * 19349663u);
    n = (n ^ n >> 13) * 0x5bd1e995u;
    return float((n ^ n >> 15) & 255) / 256.0f;  // half floats hold it to the bit
}

double largest_difference(const ImageRgb& a, const ImageRgb& b) {
    double most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        most = std::max(most, std::fabs(double(a.pixels[i].g) - double(b.pixels[i].g)));
    return most;
}

}  // namespace

TEST_CASE_METHOD(OnBloom, "the truth is a double sum over a square in double precision, for every border") {
    const std::pair<const char*, truth::Border> borders[] = {
        {"clamp", truth::Border::clamp}, {"mirror", truth::Border::mirror}, {"black", truth::Border::black}};
    truth::Field field{19, 13, {}};
    for (int y = 0; y < 13; ++y)
        for (int x = 0; x < 19; ++x) field.values.push_back(double(noise(x, y)));
    for (const auto& [name, border] : borders)
        for (const float sigma : {0.1f, 0.7f, 2.5f}) {
            bloom.border.set(name);
            const ImageRgb found = spread_of("exact", sigma, {19, 13}, noise);
            const truth::Field right = truth::blur(field, double(sigma), border);
            double worst = 0;
            for (size_t i = 0; i < right.values.size(); ++i)
                worst = std::max(worst, std::fabs(double(found.pixels[i].g) - right.values[i]));
            INFO(name << " " << sigma);
            CHECK(worst < 5e-6);  // cut off at 5 sigma, and 32 bits
        }
}

TEST_CASE_METHOD(OnBloom, "methods that read each neighbour are one picture, for every border") {
    for (const std::string border : {"clamp", "mirror", "black"})
        for (const float sigma : {0.0f, 0.3f, 1.0f, 3.0f}) {
            bloom.border.set(border);
            const ImageRgb separable = spread_of("separable", sigma, {37, 300}, noise);
            for (const std::string method : {"shared", "paired", "window"}) {
                INFO(method << " " << border << " " << sigma);
                CHECK(largest_difference(spread_of(method, sigma, {37, 300}, noise), separable) < 2e-3);
            }
        }
}

TEST_CASE_METHOD(OnBloom, "infinity, NaN and what is above 65504 stay finite, and reach no farther than light does",
                 "[08.not_finite]") {
    const float inf = std::numeric_limits<float>::infinity();
    for (const float bad : {inf, -inf, std::nanf(""), 65504.0f, 70000.0f})
        for (const std::string& method : blurs)
            for (const std::string cut : {"none", "hard", "soft"}) {
                if (cut != "none" && method != "pyramid") continue;
                bloom.cut.set(cut);
                const auto plain = [](int x, int y) { return 4.0f * noise(x, y); };
                const ImageRgb without = spread_of(method, 2, {96, 24}, plain);
                const ImageRgb with = spread_of(method, 2, {96, 24},
                                                [&](int x, int y) { return x == 10 && y == 12 ? bad : plain(x, y); });
                INFO(method << " " << cut << " " << bad);
                CHECK(is_finite(with));
                CHECK(is_finite(picture()));
                double far = 0;
                for (int y = 0; y < 24; ++y)
                    for (int x = 40; x < 96; ++x)
                        far = std::max(far, std::fabs(double(with.at(x, y).g) - double(without.at(x, y).g)));
                CHECK(far == 0);
            }
}

TEST_CASE_METHOD(OnBloom, "sigma from 0.1 to 200 pixels: finite, and no light is lost or made") {
    for (const std::string shape : {"gaussian", "sum"})
        for (const float sigma : {0.0f, 0.1f, 0.29f, 0.5f, 2.1f, 2.13f, 30.0f, 200.0f})
            for (const std::string& method : blurs) {
                if (method == "window" && sigma > 3) continue;  // a million reads a pixel
                bloom.shape.set(shape);
                bloom.border.set("mirror");  // light leaving on one side returns
                const ImageRgb found = spread_of(method, sigma, {64, 48}, spot_at(32, 24));
                INFO(method << " " << shape << " " << sigma);
                CHECK(is_finite(found));
                // A Kawase filter far wider than the picture is folded into it at a few texels.
                CHECK(sum(found) == Approx(1000).epsilon(method == "dual_kawase" && sigma >= 30 ? 0.03 : 0.01));
            }
}

TEST_CASE_METHOD(OnBloom, "below 0.3 pixels a Gaussian falls between the pixels: its blur is less than was asked for",
                 "[08.narrow]") {
    CHECK(variance(spread_of("separable", 0.2f, {16, 16}, spot_at(8, 8))) < 0.1 * 0.2 * 0.2);
    CHECK(variance(spread_of("separable", 0.3f, {16, 16}, spot_at(8, 8))) == Approx(0.3 * 0.3).epsilon(0.95));
    CHECK(variance(spread_of("separable", 0.8f, {16, 16}, spot_at(8, 8))) == Approx(0.8 * 0.8).epsilon(0.02));
}

TEST_CASE_METHOD(OnBloom, "energy is kept within 1 percent away from the border; at it each rule errs in its own way",
                 "[figures]") {
    for (const std::string& method : blurs) {
        const ImageRgb inside = spread_of(method, 4, {96, 80}, spot_at(48, 40));
        INFO(method);
        CHECK(sum(inside) == Approx(1000).epsilon(0.01));
        double kept[3];
        int i = 0;
        for (const std::string border : {"clamp", "mirror", "black"}) {
            bloom.border.set(border);
            kept[i++] = sum(spread_of(method, 4, {96, 80}, spot_at(0, 40))) / 1000;
        }
        bloom.border.set("clamp");
        fmt::print("light kept of a pixel at the border, {:16} clamp {:.2f} mirror {:.2f} black {:.2f}\n", method,
                   kept[0], kept[1], kept[2]);
        const bool anew = method == "pingpong" || method == "three_pass_7tap";     // each pass has its border again
        CHECK(kept[0] == Approx(anew ? 1.4 : 2.13).epsilon(anew ? 0.15 : 0.02));   // the edge's pixel stands for all
        CHECK(kept[1] == Approx(1).margin(0.06));                                  // light that leaves comes back
        CHECK(kept[2] == Approx(anew ? 0.32 : 0.55).epsilon(anew ? 0.25 : 0.05));  // half of it leaves, and more
    }
}

TEST_CASE_METHOD(OnBloom, "Karis's weights lose two thirds of a bright pixel's light", "[08.karis]") {
    const auto spot = spot_at(32, 32);
    CHECK(sum(spread_of("pyramid", 8, {64, 64}, spot)) == Approx(1000).epsilon(0.01));
    bloom.karis.value = true;
    CHECK(sum(spread_of("pyramid", 8, {64, 64}, spot)) < 0.4 * 1000);
    const ImageRgb even = spread_of("pyramid", 8, {64, 64}, [](int, int) { return 3.0f; });
    CHECK(sum(even) == Approx(3 * 64 * 64).epsilon(0.01));
}

TEST_CASE_METHOD(OnBloom, "a sum of Gaussians: a pyramid adds up those that it says it stands for") {
    bloom.shape.set("sum");
    const auto spot = spot_at(80, 80, 30000);
    const ImageRgb exact = spread_of("exact", 16, {160, 160}, spot);
    CHECK(bloom.plan().sigmas_px.size() == 3);
    const ImageRgb pyramid = spread_of("pyramid", 16, {160, 160}, spot);
    CHECK(bloom.plan().sigmas_px.size() == 3);
    CHECK(relative_l2(pyramid, exact) < 0.1);
    for (const ImageRgb& one : {exact, pyramid}) CHECK(sum(one) == Approx(30000).epsilon(0.01));
    CHECK(relative_l2(spread_of("pingpong", 16, {160, 160}, spot), exact) < 0.02);
    bloom.shape.set("gaussian");
    CHECK(relative_l2(spread_of("pyramid", 16, {160, 160}, spot), exact) > 0.5);
}

TEST_CASE_METHOD(OnBloom, "pictures of 1x1, 2x3, 1x40 and a strip of 8K: an even light stays even", "[08.sizes]") {
    for (const glm::uvec2 size : {glm::uvec2{1, 1}, {2, 3}, {1, 40}, {7680, 2}, {3, 4320}})
        for (const std::string& method : blurs) {
            const float sigma = method == "window" ? 2.0f : 20.0f;
            if (size.x + size.y > 4000 && method != "pyramid" && method != "dual_kawase" && method != "shared")
                continue;
            const ImageRgb found = spread_of(method, sigma, size, [](int, int) { return 2.5f; });
            double worst = 0;
            for (const glm::vec3& pixel : found.pixels) worst = std::max(worst, std::fabs(double(pixel.g) - 2.5));
            INFO(method << " " << size.x << "x" << size.y);
            CHECK(worst < 0.025);
        }
}

TEST_CASE_METHOD(OnBloom, "nothing above the threshold: no blur runs, and the picture is what it was",
                 "[08.nothing_bright]") {
    bloom.cut.set("soft");
    for (const std::string method : {"pyramid", "shared", "exact"}) {
        const ImageRgb lit = spread_of(method, 4, {40, 30}, spot_at(20, 15));
        CHECK(sum(lit) > 900);
        for (const float dim : {0.0f, 0.5f}) {
            const ImageRgb after = spread_of(method, 4, {40, 30}, [&](int, int) { return dim; });
            INFO(method << " " << dim);
            CHECK(largest_difference(after, lit) == 0);  // unwritten image: result of the previous frame
            CHECK(sum(picture()) == Approx(double(dim) * 40 * 30));
        }
        CHECK(sum(spread_of(method, 4, {40, 30}, spot_at(20, 15))) > 900);  // and at once when there is light
    }
}

TEST_CASE_METHOD(OnBloom, "a hard cut goes by luminance, whatever the colour, and takes all of it") {
    bloom.cut.set("hard");
    bloom.method.set("pyramid");
    const glm::vec3 colors[] = {{4, 0.1f, 0.1f},  {0.2f, 1.5f, 0.2f}, {0.1f, 0.1f, 9},
                                {0.1f, 0.1f, 20}, {5, 0, 0},          {0, 1.3f, 0}};
    record({6, 1}, [&](int x, int) { return colors[x]; });
    const ImageRgb out = read_linear(gpu, bloom.cut_out());
    for (int x = 0; x < 6; ++x) {
        const bool passes = truth::luminance(glm::dvec3(colors[x])) > 1;
        INFO(x << ", luminance " << truth::luminance(glm::dvec3(colors[x])));
        for (int c = 0; c < 3; ++c)
            CHECK(double(out.at(x, 0)[c]) == Approx(passes ? double(colors[x][c]) : 0).epsilon(1e-3));
    }
}

TEST_CASE_METHOD(OnBloom, "added light is added, mixed light is moved; alpha stays") {
    bloom.method.set("pyramid");
    bloom.sigma_px.value = 4;
    const auto spot = spot_at(30, 30);
    for (const auto& [compose, total] : {std::pair{"add", 1500.0}, {"mix", 1000.0}}) {
        bloom.compose.set(compose);
        record({60, 60}, spot);
        CHECK(sum(picture()) == Approx(total).epsilon(0.01));
    }
    const auto texels = OnDevice::numbers<uint64_t>(gpu.read_back(hdr));
    CHECK(glm::unpackHalf4x16(texels[30 * 60 + 30]).a == 0.25f);
    bloom.method.set("none");
    record({60, 60}, spot);
    CHECK(sum(picture()) == Approx(1000).epsilon(0.001));
}

TEST_CASE("the plans: chained variances add up to what was asked for, and steps stay within their images",
          "[08.plans]") {
    for (const std::string& method : blurs)
        for (double sigma = 0; sigma <= (method == "window" ? 20 : 200); sigma = sigma * 1.3 + 0.1)
            for (const bool sum : {false, true}) {
                const Plan plan = plan_blur({.method = method, .sigma_px = sigma, .sum = sum, .size = {1920, 1080}});
                INFO(method << " " << sigma);
                CHECK(plan.sigmas_px.back() == sigma);
                float shares = 0;
                for (const Step& step : plan.steps) {
                    CHECK(step.first_tap + step.taps <= plan.taps.size());
                    CHECK(size_t(step.into) < plan.sizes.size());
                    CHECK(step.from != step.into);
                    if (step.kind == Step::Kind::shared) CHECK(step.taps - 1 <= 896);
                    if (step.into == 1) shares += step.weight;
                }
                if (!sum && method != "pyramid") CHECK(shares == Approx(1));
                CHECK(plan.steps.back().into == 1);
            }
    CHECK(plan_blur({.method = "pingpong", .sigma_px = 32, .size = {64, 64}}).steps.size() == 20);
    CHECK(plan_blur({.method = "three_pass_7tap", .sigma_px = 2, .size = {64, 64}}).steps.size() == 6);
    CHECK(failure_of([] { plan_blur({.method = "pyramid", .sigma_px = 3, .size = {8, 8}}); }).empty());
    CHECK_THROWS_AS(plan_blur({.method = "blurry"}), InputError);
    CHECK_THROWS_AS(plan_blur({.method = "window", .sigma_px = 200}), InputError);  // minutes for a picture
}
