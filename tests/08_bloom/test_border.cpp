// A lamp at the picture's border, at sizes of which most halve to odd numbers: its light is there once.
#include <fmt/core.h>

#include "bloom_fixture.h"

using namespace lightwalk;

namespace {

const std::vector<std::string> over_levels{"pyramid", "dual_kawase"};

/// That many pixels in a row; from 88 on nothing of a sigma of 16 gets from the first to the last.
constexpr int first_size = 88, last_size = 127;

}  // namespace

// A mirrored picture keeps one half of the halo of a lamp at its border, twice: light is lost or made as the halves differ.
TEST_CASE_METHOD(OnBloom, "a lamp in the middle: its halo leans to neither side", "[figures][08.halo][08.lamp]") {
    for (const std::string& method : over_levels) {
        double most = 0;
        for (int x = 60; x < 68; ++x) {
            const ImageRgb found = spread_of(method, 7, {128, 64}, spot_at(x, 32, 20000));
            double left = 0, right = 0;
            for (int v = 0; v < 64; ++v)
                for (int u = 0; u < 128; ++u)
                    if (u != x) (u < x ? left : right) += double(found.at(u, v).g);
            most = std::max(most, std::fabs(right / left - 1));
        }
        fmt::print("a lamp inside, {:12}: its halo's halves differ by up to {:.3f}\n", method, most);
        CHECK(most < (method == "pyramid" ? 0.01 : 0.05));
    }
}

TEST_CASE_METHOD(OnBloom, "a lamp in the last column, row or corner, at 40 sizes: as the truth, its light once",
                 "[figures][08.border][08.lamp]") {
    for (const std::string border : {"mirror", "clamp", "black"}) {
        bloom.border.set(border);
        struct Worst {
            double light = 0, off = 0;
        } worst[2];
        for (int side = first_size; side <= last_size; ++side) {
            const glm::uvec2 sizes[] = {{side, 24}, {24, side}, {side, 215 - side}};
            const glm::ivec2 places[] = {{side - 1, 12}, {12, side - 1}, {side - 1, 214 - side}};
            for (int i = 0; i < 3; ++i) {
                const auto lamp = spot_at(places[i].x, places[i].y, 20000);
                const float sigma = side % 2 ? 16.0f : 7.0f;
                const ImageRgb exact = spread_of("exact", sigma, sizes[i], lamp);
                for (size_t m = 0; m < over_levels.size(); ++m) {
                    const ImageRgb found = spread_of(over_levels[m], sigma, sizes[i], lamp);
                    INFO(over_levels[m] << " " << border << " " << sizes[i].x << "x" << sizes[i].y << " sigma "
                                        << sigma);
                    const double light = sum(found) / sum(exact), off = relative_l2(found, exact);
                    CHECK(light == Approx(1).margin(m == 0 ? 0.01 : 0.05));
                    CHECK(off < (m == 0 ? 0.015 : 0.1));
                    worst[m].light = std::max(worst[m].light, std::fabs(light - 1));
                    worst[m].off = std::max(worst[m].off, off);
                }
            }
        }
        for (size_t m = 0; m < over_levels.size(); ++m)
            fmt::print("a lamp at the last border, {:12} {:6}: light off by at most {:.4f}, picture by {:.4f}\n",
                       over_levels[m], border, worst[m].light, worst[m].off);
    }
}

TEST_CASE_METHOD(OnBloom,
                 "a lamp in the middle of a mirrored picture: its light is there once, at odd sizes and wide blurs",
                 "[figures][08.light][08.lamp]") {
    bloom.border.set("mirror");
    for (const std::string& method : over_levels)
        for (const glm::uvec2 size :
             {glm::uvec2(101, 67), glm::uvec2(120, 67), glm::uvec2(97, 55), glm::uvec2(128, 72)})
            for (const float sigma : {6.0f, 12.0f, 24.0f}) {
                double least = 2, most = 0;
                for (int i = 0; i < 8; ++i) {
                    const ImageRgb found =
                        spread_of(method, sigma, size, spot_at(int(size.x) / 2 - i, int(size.y) / 2 + i, 20000));
                    least = std::min(least, sum(found) / 20000);
                    most = std::max(most, sum(found) / 20000);
                }
                fmt::print("light kept, {:12} {}x{} sigma {}: {:.3f} to {:.3f}\n", method, size.x, size.y, sigma, least,
                           most);
                INFO(method << " " << size.x << "x" << size.y << " sigma " << sigma);
                CHECK(least > 0.97);
                CHECK(most < 1.03);
            }
}
