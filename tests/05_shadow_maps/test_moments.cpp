// Moments: light leaks, and the limits of their formats.
#include "shadow_fixture.h"

using namespace lightwalk;

namespace {

Macros of_method(const char* method, const char* format = "fp32") {
    NoChapter chapter;
    Shadow shadow(chapter, "shadow");
    shadow.method.set(method);
    shadow.format.set(format);
    return shadow.macros();
}

float ask(const char* method, const std::string& signature, Row row, const char* format = "fp32") {
    return static_cast<float>(run_probe(check_device(),
                                        {.include = "05_shadow_maps/shadow.glsl",
                                         .signature = signature,
                                         .inputs = {std::move(row)},
                                         .macros = of_method(method, format)},
                                        1)[0][0]);
}

// The moments of half `a` and half `b`.
Row half_and_half(double a, double b) {
    Row row;
    for (int power = 1; power <= 4; ++power) row.push_back(0.5 * (std::pow(a, power) + std::pow(b, power)));
    return row;
}

}  // namespace

TEST_CASE("two occluders, at 0 and 0.9, above a receiver at 1: VSM lets 40% of the light through where there is none",
          "[05.occluders]") {
    const Row moments = half_and_half(0, 0.9);
    const float vsm =
        ask("vsm", "float chebyshev(vec2 moments, float depth, float least)", {moments[0], moments[1], 1, 1e-7});
    CHECK(vsm == Approx(0.401f).margin(1e-3));
    Row four = moments;
    four.insert(four.end(), {1.0, 1e-5});
    const float msm = ask("msm", "float msm(vec4 moments, float z, float bias)", four);
    INFO("msm " << msm);
    CHECK(msm < 0.01f);  // four moments resolve exactly two depths
    const auto evsm = [&](double exponent, double negative, const char* format) {
        Row row(4, 0.0);
        for (const double depth : {0.0, 0.9}) {
            const double p = std::exp(exponent * (2 * depth - 1)), n = -std::exp(-negative * (2 * depth - 1));
            row[0] += 0.5 * p;
            row[1] += 0.5 * n;
            row[2] += 0.5 * p * p;
            row[3] += 0.5 * n * n;
        }
        row.insert(row.end(), {1.0, exponent, negative, 1e-7});
        return ask("evsm",
                   "float evsm(vec4 moments, float depth, float exponent, float exponent_negative, float least)", row,
                   format);
    };
    const float strong = evsm(40, 5, "fp32"), weak = evsm(5.54, 5, "fp16");
    INFO("evsm " << strong << " and, with what halves hold, " << weak);
    CHECK(strong < 1e-3f);
    CHECK(weak > 0.03f);
    CHECK(weak < 0.05f);
}

TEST_CASE("an even occluder has no variance: the least one says how much light is left behind it, in vsm and evsm") {
    // In evsm the smallest variance is one of depth: the warp scales it by its slope.
    for (const double least : {1e-5, 1e-3})
        for (const double behind : {0.003, 0.02}) {
            const double at = 0.6, a = 8, b = 3, w = std::exp(a * (2 * at - 1)), n = -std::exp(-b * (2 * at - 1));
            const auto seen = [&](double exponent, double occluder, double receiver) {
                const double variance = least * std::pow(2 * exponent * receiver, 2), d = receiver - occluder;
                return d <= 0 ? 1 : variance / (variance + d * d);
            };
            const double right = std::min(seen(a, w, std::exp(a * (2 * (at + behind) - 1))),
                                          seen(b, n, -std::exp(-b * (2 * (at + behind) - 1))));
            const float found = ask(
                "evsm", "float evsm(vec4 moments, float depth, float exponent, float exponent_negative, float least)",
                {w, n, w * w, n * n, at + behind, a, b, least});
            INFO(least << " " << behind);
            CHECK(double(found) == Approx(right).epsilon(5e-3));
        }
    ShadowScene test({object_at(quad_file, {0, 0, -1}, glm::vec3(8)), object_at(quad_file, {0, 0, 1}, glm::vec3(2))},
                     {sun_at(2)});
    for (const char* method : {"vsm", "evsm"}) {
        std::vector<double> squares;  // of how far the receiver is behind, by the Chebyshev bound
        for (const char* least : {"1e-3", "1e-2", "1e-1"}) {
            test.set({{"method", method}, {"format", "fp32"}, {"blur", "0"}, {"mips", "off"}, {"resolution", "256"}});
            test.set({{"cascades", "1"}, {"exponent", "1"}, {"exponent_negative", "0.5"}, {"min_variance", least}});
            test.set({{"bleed", "0"}});
            const double seen = double(test.visibility({{0, 0, -1}, {0, 0, 1}}));
            INFO(method << " with a least variance of " << least << ": " << seen);
            CHECK(seen > 1e-4);
            CHECK(seen < 0.9999);
            squares.push_back(std::stod(least) * (1 / seen - 1));
        }
        CHECK(squares[1] == Approx(squares[0]).epsilon(0.02));
        CHECK(squares[2] == Approx(squares[0]).epsilon(0.02));
    }
}

TEST_CASE("three occluders are more than four moments tell apart: MSM leaks, too", "[05.occluders]") {
    Row row;
    for (int power = 1; power <= 4; ++power)
        row.push_back((std::pow(0.0, power) + std::pow(0.45, power) + std::pow(0.9, power)) / 3);
    row.insert(row.end(), {1.0, 1e-5});
    const float msm = ask("msm", "float msm(vec4 moments, float z, float bias)", row);
    INFO(msm);
    CHECK(msm > 0.05f);
    CHECK(msm < 0.35f);
}

TEST_CASE("exponents at their caps fit their formats, those above do not and are not used") {
    const auto square = [](double exponent) { return std::exp(2 * exponent); };
    CHECK(square(42) < double(std::numeric_limits<float>::max()));
    CHECK(square(44.4) > double(std::numeric_limits<float>::max()));
    CHECK(square(5.54) < 65504);
    CHECK(square(5.55) > 65504);
    const auto moments = [](const char* format, double exponent) {
        return run_probe(check_device(),
                         {.include = "05_shadow_maps/shadow.glsl",
                          .signature = "vec4 moments_of(float depth, float exponent, float exponent_negative)",
                          .inputs = {{1.0, exponent, exponent}, {0.0, exponent, exponent}},
                          .macros = of_method("evsm", format)},
                         4);
    };
    for (const char* format : {"fp16", "fp32"}) {
        const double most = std::string(format) == "fp16" ? 65504 : double(std::numeric_limits<float>::max());
        for (const Row& row : moments(format, 80))
            for (const double value : row) CHECK(std::fabs(value) < most);
    }
    CHECK(moments("fp32", 80) == moments("fp32", 42));
    CHECK(moments("fp16", 80) == moments("fp16", 5.54));
}

TEST_CASE("the variance of a plane is noise: 2e-4 in halves, 5e-8 in floats", "[05.plane_variance]") {
    const auto noise = [](const char* format) {
        // Two planes, so that the near one is at 0.1 and the far one at 0.9 of the depth between.
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 1}, glm::vec3(0.01f))},
                         {sun_at(2)});
        test.set({{"method", "vsm"}, {"format", format}, {"blur", "0"}, {"resolution", "256"}, {"cascades", "1"}});
        test.visibility({{0, 0, 0}, {0, 0, 1}});
        const Image& moments = test.shadow.moments();
        const auto bytes = test.gpu.read_back(moments.layer(0).mip(0));
        double squares = 0, count = 0;
        const size_t texel = bytes.size() / (256 * 256);
        for (size_t at = 0; at < bytes.size(); at += texel) {
            glm::vec4 m;
            uint64_t halves = 0;
            if (texel == 8) {
                std::memcpy(&halves, &bytes[at], 8);
                m = glm::unpackHalf4x16(halves);
            }
            if (texel == 16) std::memcpy(&m, &bytes[at], 16);
            if (m.x > 0.999f || m.x < 0.5f) continue;
            const double variance = double(m.y) - double(m.x) * double(m.x);
            squares += variance * variance;
            ++count;
        }
        return std::sqrt(squares / count);
    };
    const double halves = noise("fp16"), floats = noise("fp32");
    INFO(halves << " and " << floats);
    CHECK(halves > 5e-5);
    CHECK(halves < 5e-4);
    CHECK(floats < 2e-7);
    CHECK(floats > 0);
}

TEST_CASE("without its bias MSM divides noise by noise; with it a plane is lit; halves need thousands of times as much",
          "[05.moment_bias]") {
    const auto worst = [](const char* format, const char* bias) {
        ShadowScene test({object_at(quad_file, {0, 0, 0}), object_at(quad_file, {0, 0, 1}, glm::vec3(0.01f))},
                         {sun_at(30)});
        test.set({{"method", "msm"}, {"format", format}, {"cascades", "1"}, {"resolution", "256"}, {"blur", "2"}});
        test.set({{"bias_m", "0.02"}, {"moment_bias", bias}});
        float least = 1;
        for (const float visible : test.visibility(square(5000, 0.7f))) least = std::min(least, visible);
        return least;
    };
    const float none = worst("fp32", "0"), little = worst("fp32", "1e-5");
    INFO("the darkest point of a lit plane, in floats: " << none << " without a bias, " << little << " with 1e-5");
    CHECK(none < 0.9f);
    CHECK(little > 0.9f);
    for (const char* bias : {"1e-5", "1e-3", "1e-2"}) {
        const float halves = worst("fp16", bias);
        INFO("in halves with " << bias << ": " << halves);
        CHECK((std::string(bias) != "1e-2" ? halves < 0.5f : halves > 0.9f));
    }
}
