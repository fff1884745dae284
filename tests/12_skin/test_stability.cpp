// Where skin goes wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include "spread_fixture.h"

using namespace lightwalk;

namespace {

const int sums[] = {1, 2, 3, 4, 6};

glm::dvec3 largest(glm::dvec3 a, glm::dvec3 b) { return glm::max(a, glm::abs(b)); }

// The largest error of a sum against all six at an edge of light, for each channel.
glm::dvec3 step_error(const std::vector<Gaussian>& sum) {
    glm::dvec3 worst(0);
    for (int i = -1200; i <= 1200; ++i)
        worst = largest(worst, step_edge(sum, 0.01 * i) - step_edge(gaussians_of(6), 0.01 * i));
    return worst;
}

void check_near(glm::dvec3 found, glm::dvec3 right, double tolerance) {
    for (int c = 0; c < 3; ++c) CHECK(std::fabs(found[c] - right[c]) <= tolerance);
}

}  // namespace

TEST_CASE("an edge of light under fewer Gaussians is off by what was published, and the sums kept are the best",
          "[12.fewer_gaussians]") {
    check_near(step_error(gaussians_of(1)), {.138, .112, .079}, 6e-4);
    check_near(step_error(merged({1, 4})), {.043, .084, .147}, 6e-4);
    check_near(step_error(merged({0, 1, 3, 4})), {.012, .026, 0}, 6e-4);
    glm::dvec3 unblurred(0);
    for (const double x : {-1e-9, 1e-9}) unblurred = largest(unblurred, step_edge(gaussians_of(6), x) - double(x > 0));
    check_near(unblurred, {.5, .5, .5}, 1e-6);
    // Of all sums of two, three and four of the six, gaussians_of() returns the ones with the smallest error.
    for (const int count : {2, 3, 4}) {
        double least = 1;
        for (unsigned set = 0; set < 64; ++set) {
            std::vector<size_t> kept;
            for (size_t i = 0; i < 6; ++i)
                if (set >> i & 1) kept.push_back(i);
            if (int(kept.size()) != count) continue;
            const glm::dvec3 error = step_error(merged(kept));
            least = std::min(least, std::max({error.x, error.y, error.z}));
        }
        const glm::dvec3 own = step_error(gaussians_of(count));
        fmt::print("{} Gaussians: step edge off by {:.3f} {:.3f} {:.3f}\n", count, own.x, own.y, own.z);
        CHECK(std::max({own.x, own.y, own.z}) <= least + 1e-9);
    }
    for (const int count : sums) {
        glm::vec3 whole(0);
        for (const Gaussian& g : gaussians_of(count)) whole += g.weight;
        check_near(whole, glm::dvec3(1), 1e-6);
    }
    CHECK_THROWS_AS(gaussians_of(5), Failure);
}

TEST_CASE_METHOD(OnSpread, "an edge of light on a map is that of the sum, for every sum, along u and along v") {
    for (const bool along_v : {false, true})
        for (const int count : sums) {
            FlatMap map{.size = along_v ? glm::uvec2(2, 256) : glm::uvec2(256, 2), .per_mm = {12, 12}};
            map.light = [&](int x, int y) { return glm::vec3((along_v ? y : x) >= 128); };
            const ImageRgb found = leaving(map, count);
            glm::dvec3 worst(0);
            for (int i = 0; i < 256; ++i) {
                const double mm = (i + 0.5 - 128) / 12;
                if (std::fabs(mm) > 6) continue;  // beyond, the map has an end
                worst = largest(
                    worst, glm::dvec3(along_v ? found.at(0, i) : found.at(i, 0)) - step_edge(gaussians_of(count), mm));
            }
            INFO(count << (along_v ? " along v" : " along u"));
            CHECK(std::max({worst.x, worst.y, worst.z}) < 0.012);
        }
}

TEST_CASE_METHOD(OnSpread, "the truth in 32 bits is a double sum in 64 on a curved patch with two charts") {
    FlatMap map{.size = {40, 40}, .per_mm = {2, 3}};
    map.light = [](int x, int y) { return glm::vec3(x % 7 < 3, y % 5 < 2, (x + y) % 2); };
    map.chart = [](int x, int y) { return x + y > 52 ? 2 : x < 3 && y < 3 ? 0 : 1; };
    map.place_mm = [](double u, double v) { return glm::dvec3(6 * std::sin(u / 6), v, 6 * std::cos(u / 6)); };
    const ImageRgb found = leaving(map, 0);
    const auto texels = texels_of(map);
    glm::dvec3 worst(0);
    for (size_t i = 0; i < texels.size(); ++i)
        if (texels[i].chart) worst = largest(worst, glm::dvec3(found.pixels[i]) - truth::diffused(texels, i));
    // Narrow Gaussians end at 4 sigma on the device: 3e-4 of their own weight.
    CHECK(std::max({worst.x, worst.y, worst.z}) < 2e-4);
}

TEST_CASE_METHOD(OnSpread, "charts that touch give each other nothing", "[12.charts]") {
    FlatMap map{.size = {48, 48}, .per_mm = {3, 3}};
    map.chart = [](int x, int) { return x < 20 ? 1 : x < 40 ? 2 : 0; };
    map.light = [](int x, int) { return x < 20 ? glm::vec3(1, 0.5f, 0.25f) : glm::vec3(0); };
    for (const int count : {1, 2, 3, 4, 6, 0}) {
        const ImageRgb found = leaving(map, count);
        double lit = 0, dark = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 20; ++x)
                for (int c = 0; c < 3; ++c) lit = std::max(lit, std::fabs(double(found.at(x, y)[c]) - 1.0 / (1 << c)));
            for (int x = 20; x < 48; ++x) dark = std::max(dark, double(found.at(x, y).r));
        }
        INFO(count);
        // Even light stays even up to the border. A conversion to half floats may round towards zero: 2^-11 of values from
        // 0.5 to 1 for each image, two of each Gaussian and their sum.
        CHECK(lit <= (count ? 2 * count + 1 : 1) * 0x1p-11 + 1e-6);
        CHECK(dark == 0);
    }
}

TEST_CASE_METHOD(OnSpread, "Gaussians narrower than a texel keep their variance, and never a negative weight",
                 "[12.narrow_gaussians]") {
    for (const float per_mm : {0.1f, 0.4f, 1.0f, 2.5f}) {
        FlatMap map{.size = {101, 3}, .per_mm = {per_mm, per_mm}};
        map.light = [](int x, int) { return glm::vec3(x == 50 ? 1000 : 0); };
        leaving(map, 6);
        for (size_t i = 0; i < 6; ++i) {
            const ImageRgb level = read_linear(gpu, spread.level(i));
            double sum = 0, square = 0, least = 0;
            for (int x = 0; x < 101; ++x) {
                const double light = double(level.at(x, 1).r);
                sum += light;
                square += light * (x - 50) * (x - 50);
                least = std::min(least, light);
            }
            const double texels = double(skin_variance_mm2[i] * per_mm * per_mm), found = square / sum;
            INFO(per_mm << " " << i);
            CHECK(std::fabs(sum - 1000) < 3);
            CHECK(least >= 0);
            CHECK(std::fabs(found - texels) < 0.05 * texels + 0.002);
        }
    }
}

TEST_CASE_METHOD(OnSpread, "where a map is stretched ten times, light still spreads in mm", "[12.stretched]") {
    FlatMap map{.size = {301, 61}, .per_mm = {20, 2}};
    map.light = [](int x, int y) { return glm::vec3(x == 150 && y == 30 ? 60000 : 0); };
    for (const int count : {6, 0}) {
        const ImageRgb found = leaving(map, count);
        double sum = 0, u = 0, v = 0;
        for (int y = 0; y < 61; ++y)
            for (int x = 0; x < 301; ++x) {
                const double light = double(found.at(x, y).r), du = (x - 150) / 20.0, dv = (y - 30) / 2.0;
                if (du * du + dv * dv > 49) continue;  // as far as the map goes along u
                sum += light;
                u += light * du * du;
                v += light * dv * dv;
            }
        INFO(count);
        CHECK(is_finite(found));
        // The truth takes Gaussians narrower than a texel, along v, for narrower than they are.
        CHECK(std::fabs(u / v - 1) < (count ? 0.04 : 0.1));
    }
    // As though texels were square: the same spot is a hundred times as wide one way.
    FlatMap naive = map;
    naive.per_mm = {6.3f, 6.3f};
    const ImageRgb found = leaving(naive, 6);
    double u = 0, v = 0;
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 301; ++x) {
            u += double(found.at(x, y).r) * std::pow((x - 150) / 20.0, 2);
            v += double(found.at(x, y).r) * std::pow((y - 30) / 2.0, 2);
        }
    CHECK(v / u > 30);
}

TEST_CASE_METHOD(OnSpread, "light that is not finite, or near the end of halves, stays in its place and stays finite") {
    for (const float light : {65504.0f, 1e-7f, 0.0f}) {
        FlatMap map{.size = {32, 32}};
        map.light = [&](int, int) { return glm::vec3(light); };
        for (const int count : {1, 6, 0}) {
            const ImageRgb found = leaving(map, count);
            CHECK(is_finite(found));
            CHECK(std::fabs(double(found.at(16, 16).g - light)) <= 2e-3 * double(light) + 1e-7);
        }
    }
}

TEST_CASE("a line of light over the picture is the profile's, and all of it", "[12.line_of_light]") {
    for (const int side : {4, 8, 16}) {
        const std::vector<glm::vec4> kernel = line_kernel(side);
        glm::dvec3 sum(0), edge(0), worst(0);
        for (const glm::vec4& tap : kernel) sum += glm::dvec3(tap);
        check_near(sum, glm::dvec3(1), 1e-6);
        // An edge between two taps.
        for (size_t i = 0; i + 1 < kernel.size(); ++i) {
            edge += glm::dvec3(kernel[i]);
            worst = largest(worst, edge - step_edge(gaussians_of(6), 0.5 * double(kernel[i].w + kernel[i + 1].w)));
        }
        CHECK(std::max({worst.x, worst.y, worst.z}) < 2e-3);
    }
}
