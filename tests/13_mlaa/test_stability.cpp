// Where filters of edges go wrong: a bound where they hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <limits>

#include "mlaa_fixture.h"

using namespace lightwalk;

namespace {

size_t nan_count(const ImageRgb& picture) {
    size_t count = 0;
    for (const glm::vec3& pixel : picture.pixels)
        count += !std::isfinite(pixel.r) || !std::isfinite(pixel.g) || !std::isfinite(pixel.b);
    return count;
}

}  // namespace

TEST_CASE_METHOD(OnMlaa, "what lies beside no edge does not change by one bit, and what changes is counted",
                 "[13.untouched]") {
    const Line line{.angle_deg = 12, .point = {40.2, 30.6}};
    const auto light = [&](int x, int y) {  // shades that fall below the threshold, and an edge
        return 0.3f + 0.002f * float((x * 7 + y * 13) % 11) + 0.5f * line.sample(x, y);
    };
    for (const std::string& method : filters) {
        filter(method, {90, 70}, light);
        const auto now = after();
        size_t far = 0;
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 90; ++x) {
                const double across = glm::dot(glm::dvec2(x, y) - line.point, line.normal());
                if (std::abs(across) > 2) far += now[size_t(y * 90 + x)] != before[size_t(y * 90 + x)];
            }
        INFO(method);
        CHECK(far == 0);
        const size_t changed = changed_texels(), counted = antialias.counts().changed;
        CHECK(changed > 90);
        CHECK(changed <= counted);
        CHECK(counted <= changed + 4);  // a share so small that a half float does not hold it
        for (const uint64_t texel : now) CHECK(glm::unpackHalf4x16(texel).a == 0.25f);
    }
    filter("none", {90, 70}, light);
    CHECK(changed_texels() == 0);
}

TEST_CASE_METHOD(OnMlaa, "an even picture lists nothing: no workgroup of what follows runs") {
    for (const std::string& method : filters) {
        const ImageRgb even = filter(method, {200, 100}, [](int, int) { return 0.4f; });
        CHECK(antialias.counts().listed == 0);
        CHECK(antialias.counts().changed == 0);
        CHECK(changed_texels() == 0);
    }
    filter("mlaa", {200, 100}, [](int x, int) { return x < 77 ? 0.1f : 0.9f; });
    CHECK(antialias.counts().listed == 200);  // both sides of one upright edge, which turns nowhere
    CHECK(antialias.counts().changed == 0);
}

TEST_CASE_METHOD(OnMlaa, "at the border: pictures of one pixel, of a row, and lines that leave the picture") {
    for (const glm::uvec2 size : {glm::uvec2{1, 1}, {2, 3}, {1, 40}, {300, 2}, {17, 16}, {16, 33}})
        for (const std::string& method : filters) {
            const ImageRgb found = filter(method, size, [](int x, int y) { return (x + y) % 3 ? 0.9f : 0.1f; });
            CHECK(nan_count(found) == 0);
            for (const glm::vec3& pixel : found.pixels) CHECK((pixel.g >= 0.0999f && pixel.g <= 0.9004f));
        }
    // A line that the border cuts goes on outside, as long as the one before it.
    for (const double angle : {1.2, 4.0, 86.0, 178.8})
        for (const std::string method : {"mlaa", "smaa_like"}) {
            const Line line{.angle_deg = angle, .point = {63.4, 63.7}};
            const auto light = [&](int x, int y) { return line.sample(x, y); };
            const ImageRgb found = filter(method, {128, 128}, light);
            const double inside = edge_error(found, line, 32), with_border = edge_error(found, line, 0);
            fmt::print("{} at {} degrees: error {:.4f} inside, {:.4f} with the border\n", method, angle, inside,
                       with_border);
            INFO(method << " at " << angle);
            CHECK(inside < 0.05);
            CHECK(with_border < 0.05);
        }
}

TEST_CASE_METHOD(OnMlaa, "smaa_like: a corner keeps a quarter of its weight", "[13.smaa_corner]") {
    const auto box = [](int x, int y) { return x >= 20 && x < 60 && y >= 20 && y < 50 ? 1.0f : 0.0f; };
    const ImageRgb mlaa = filter("mlaa", {80, 70}, box), smaa = filter("smaa_like", {80, 70}, box);
    CHECK(1 - double(mlaa.at(22, 20).g) == Approx(truth::area(2, 40)).margin(1e-3));
    CHECK(1 - double(smaa.at(22, 20).g) == Approx(0.25 * truth::area(2, 40)).margin(1e-3));
    CHECK(1 - double(mlaa.at(20, 23).g) == Approx(truth::area(3, 30)).margin(1e-3));
    CHECK(1 - double(smaa.at(20, 23).g) == Approx(0.25 * truth::area(3, 30)).margin(1e-3));
}

TEST_CASE_METHOD(OnMlaa, "smaa_like: a detail of one pixel takes an eighth of each neighbour that it differs from",
                 "[13.smaa_detail]") {
    const auto pixel = [](int x, int y) { return x == 15 && y == 15 ? 1.0f : 0.0f; };
    CHECK(double(filter("smaa_like", {32, 32}, pixel).at(15, 15).g) == Approx(0.5).margin(1e-3));
    CHECK(double(filter("mlaa", {32, 32}, pixel).at(15, 15).g) == 1);
    // On a plane, whichever side it stands on: three neighbours.
    for (const glm::ivec2 out : {glm::ivec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const ImageRgb found = filter("smaa_like", {32, 32}, [&](int x, int y) {
            const glm::ivec2 from = glm::ivec2(x, y) - 15;
            return from == glm::ivec2(0) || from.x * out.x + from.y * out.y < 0 ? 1.0f : 0.0f;
        });
        INFO(out.x << ", " << out.y);
        CHECK(double(found.at(15, 15).g) == Approx(1 - 3.0 / 8).margin(1e-3));
    }
    // The last pixel of a step of a thin line has three such neighbours, too, and stays a part of the line.
    const auto wire = [](int x, int y) { return y == (x < 6 ? 14 : x < 16 ? 15 : x < 26 ? 16 : 17) ? 1.0f : 0.0f; };
    const ImageRgb mlaa = filter("mlaa", {32, 32}, wire), smaa = filter("smaa_like", {32, 32}, wire);
    for (int x = 7; x < 25; ++x)
        for (int y = 13; y < 19; ++y) CHECK(smaa.at(x, y) == mlaa.at(x, y));
}

TEST_CASE_METHOD(OnMlaa, "edges of 0.5 to 89 degrees against their exact coverage", "[figures]") {
    struct Case {
        double angle, fxaa, mlaa, smaa;  // bounds
    };
    for (const Case& one : {Case{1, 0.17, 0.11, 0.11},
                            {3, 0.03, 0.04, 0.04},
                            {5, 0.05, 0.03, 0.03},
                            {10, 0.06, 0.05, 0.05},
                            {20, 0.08, 0.08, 0.08},
                            {30, 0.11, 0.12, 0.08},
                            {40, 0.15, 0.18, 0.03},
                            {44, 0.19, 0.23, 0.03},
                            {60, 0.11, 0.12, 0.08},
                            {80, 0.06, 0.05, 0.05},
                            {88, 0.07, 0.06, 0.06}}) {
        const Line line{.angle_deg = one.angle, .point = {63.4, 63.7}};
        const auto light = [&](int x, int y) { return line.sample(x, y); };
        const double none = edge_error(filter("none", {128, 128}, light), line);
        const double fxaa = edge_error(filter("fxaa_like", {128, 128}, light), line);
        const double mlaa = edge_error(filter("mlaa", {128, 128}, light), line);
        const double smaa = edge_error(filter("smaa_like", {128, 128}, light), line);
        fmt::print("edge at {:2} degrees: none {:.3f}, fxaa_like {:.3f}, mlaa {:.3f}, smaa_like {:.3f}\n", one.angle,
                   none, fxaa, mlaa, smaa);
        INFO(one.angle << " degrees");
        CHECK(none > 0.2);
        CHECK(fxaa < one.fxaa);
        CHECK(mlaa < one.mlaa);
        CHECK(smaa < one.smaa);
    }
}

TEST_CASE_METHOD(OnMlaa,
                 "fxaa_like takes of what is smaller than a pixel as much as it stands out: half of a lone pixel") {
    // A lone pixel differs from its neighbours' mean by all of the contrast, a line of one pixel by two thirds.
    const ImageRgb lone = filter("fxaa_like", {32, 32}, [](int x, int y) { return x == 15 && y == 15 ? 1.0f : 0.0f; });
    CHECK(double(lone.at(15, 15).g) == Approx(0.5).epsilon(2e-3));
    const double stands_out = 2.0 / 3, lobe = stands_out * stands_out * (3 - 2 * stands_out);
    const ImageRgb line = filter("fxaa_like", {32, 64}, [](int x, int) { return x == 15 ? 1.0f : 0.0f; });
    CHECK(double(line.at(15, 32).g) == Approx(1 - 0.5 * lobe * lobe).epsilon(2e-3));
}

TEST_CASE_METHOD(OnMlaa, "a rotating edge: over 360 angles its pixels flicker less than without a filter",
                 "[figures]") {
    struct Found {
        double flicker = 0, error = 0;  // rms of a pixel's step that is not the exact one's, and of its error
    };
    std::map<std::string, Found> of;
    for (const std::string method : {"none", "fxaa_like", "mlaa", "smaa_like"}) {
        std::vector<double> off(24 * 24), before_off;
        double steps = 0, errors = 0, edge_pixels = 0;
        for (int angle = 0; angle < 360; ++angle) {
            const Line line{.angle_deg = double(angle) + 0.37, .point = {15.6, 15.8}};
            const ImageRgb now = filter(method, {32, 32}, [&](int x, int y) { return line.sample(x, y); });
            before_off = off;
            for (int i = 0; i < 24 * 24; ++i) {
                const int x = 4 + i % 24, y = 4 + i / 24;
                const double exact = line.exact(x, y);
                off[size_t(i)] = double(now.at(x, y).g) - exact;
                const double step = angle > 0 ? off[size_t(i)] - before_off[size_t(i)] : 0;
                steps += step * step;
                errors += off[size_t(i)] * off[size_t(i)];
                edge_pixels += exact > 1e-9 && exact < 1 - 1e-9;
            }
        }
        of[method] = {std::sqrt(steps / edge_pixels), std::sqrt(errors / edge_pixels)};
        fmt::print("rotating edge, {:10}: flicker {:.3f}, error {:.3f}\n", method, of[method].flicker,
                   of[method].error);
    }
    for (const std::string& method : filters) {
        INFO(method);
        CHECK(of[method].error < 0.6 * of["none"].error);
        CHECK(of[method].flicker < 0.7 * of["none"].flicker);
    }
    CHECK(of["smaa_like"].error < of["mlaa"].error);
}

TEST_CASE_METHOD(OnMlaa, "red against blue of one luminance: luma sees nothing, Lab does", "[13.red_blue]") {
    const glm::vec3 red(0.0722f / 0.2126f, 0, 0), blue(0, 0, 1);  // both have the luminance of blue
    const Line line{.angle_deg = 9, .point = {31.3, 31.6}};
    const auto light = [&](int x, int y) { return line.sample(x, y) > 0 ? red : blue; };
    const double lab = glm::distance(truth::to_lab(red), truth::to_lab(blue));
    CHECK(lab > 100);
    filter("fxaa_like", {64, 64}, light);
    CHECK(changed_texels() == 0);
    for (const std::string method : {"mlaa", "smaa_like"}) {
        const ImageRgb found = filter(method, {64, 64}, light);
        double square = 0, none = 0;
        for (int y = 4; y < 60; ++y)
            for (int x = 4; x < 60; ++x) {
                const double exact = 1 - line.exact(x, y);
                square += std::pow(double(found.at(x, y).b) - exact, 2);
                none += std::pow(1 - double(line.sample(x, y)) - exact, 2);
            }
        CHECK(square < 0.15 * none);
    }
}

TEST_CASE_METHOD(OnMlaa, "light of 16 against black: cut off before it is mixed, the edge is smooth; after, it is not",
                 "[figures]") {
    const Line line{.angle_deg = 7, .point = {31.3, 31.6}};
    const auto error_of = [&](const std::string& method, float bright) {
        ImageRgb found = filter(method, {64, 64}, [&](int x, int y) { return bright * line.sample(x, y); });
        for (glm::vec3& pixel : found.pixels) pixel = glm::min(pixel, 1.0f);
        return edge_error(found, line);
    };
    for (const std::string& method : filters) {
        const double none = error_of("none", 1), before_mixing = error_of(method, 1),
                     after_mixing = error_of(method, 16);
        fmt::print("{:10}: error {:.3f} cut off before, {:.3f} after (none {:.3f})\n", method, before_mixing,
                   after_mixing, none);
        CHECK(before_mixing < 0.3 * none);
        CHECK(after_mixing > 0.9 * none);
    }
}

TEST_CASE_METHOD(OnMlaa, "a NaN, an infinity and a negative pixel stay where they are", "[13.not_finite]") {
    const Line line{.angle_deg = 15, .point = {20.3, 20.6}};
    const auto plain = [&](int x, int y) { return 0.2f + 0.6f * line.sample(x, y); };
    const float inf = std::numeric_limits<float>::infinity();
    for (const float bad : {std::nanf(""), inf, -inf, -5.0f})
        for (const std::string& method : filters) {
            const ImageRgb without = filter(method, {40, 40}, plain);
            const ImageRgb with =
                filter(method, {40, 40}, [&](int x, int y) { return x == 11 && y == 22 ? bad : plain(x, y); });
            INFO(method << " " << bad);
            CHECK(nan_count(with) <= 1);
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x) {
                    const double off = std::abs(double(with.at(x, y).g) - double(without.at(x, y).g));
                    if (std::abs(x - 11) > 8 || std::abs(y - 22) > 8) CHECK(off == 0);
                    if (x != 11 || y != 22) CHECK(std::isfinite(with.at(x, y).g));
                }
        }
}

TEST_CASE_METHOD(OnMlaa, "lines of one pixel stay broken, a checkerboard stays, and strokes lose contrast",
                 "[figures][13.thin_lines]") {
    // A black line one pixel wide at 10 degrees: the area between two lines of edges.
    const auto line_error = [&](const std::string& method, double width, double angle_deg = 10) {
        const double angle = glm::radians(angle_deg);
        const glm::dvec2 normal(std::sin(angle), std::cos(angle)), point(47.3, 47.6);
        const auto exact = [&](int x, int y) {
            const glm::dvec2 from = point - glm::dvec2(x, y);
            return 1 - truth::half_plane_coverage(from - 0.5 * width * normal, normal) +
                   truth::half_plane_coverage(from + 0.5 * width * normal, normal);
        };
        const ImageRgb found = filter(method, {96, 96}, [&](int x, int y) {
            return std::abs(glm::dot(glm::dvec2(x, y) - point, normal)) < 0.5 * width ? 0.0f : 1.0f;
        });
        double square = 0, count = 0;
        for (int y = 4; y < 92; ++y)
            for (int x = 4; x < 92; ++x)
                if (exact(x, y) < 1 - 1e-9) {
                    square += std::pow(double(found.at(x, y).g) - exact(x, y), 2);
                    ++count;
                }
        return std::sqrt(square / count);
    };
    for (const double width : {0.5, 1.0, 2.0, 4.0}) {
        fmt::print("line of {:.1f} pixels at 10 degrees:", width);
        for (const std::string method : {"none", "fxaa_like", "mlaa", "smaa_like"})
            fmt::print(" {} {:.3f}", method, line_error(method, width));
        fmt::print("\n");
    }
    CHECK(line_error("mlaa", 0.5) > 0.5 * line_error("none", 0.5));  // gaps that nothing knows of
    // Steps of a thin line touch with their corners: cut there, in whichever direction it runs.
    for (const double angle : {10.0, -10.0, 80.0, 100.0})
        for (const std::string method : {"mlaa", "smaa_like"}) {
            INFO(method << " at " << angle);
            CHECK(line_error(method, 1.0, angle) < 0.06);
        }
    CHECK(line_error("mlaa", 4.0) < 0.5 * line_error("none", 4.0));

    // Every edge of a checkerboard ends in edges on both sides: nobody can tell where an outline runs.
    for (const int square : {1, 2, 5})
        for (const std::string method : {"fxaa_like", "mlaa", "smaa_like"}) {
            const auto board = [&](int x, int y) { return (x / square + y / square) % 2 ? 1.0f : 0.0f; };
            const ImageRgb plain = filter("none", {60, 60}, board), found = filter(method, {60, 60}, board);
            double off = 0;
            for (int y = 10; y < 50; ++y)
                for (int x = 10; x < 50; ++x)
                    off = std::max(off, std::abs(double(found.at(x, y).g) - double(plain.at(x, y).g)));
            fmt::print("checkerboard of {} pixels, {:10}: changed by at most {:.3f}\n", square, method, off);
            if (method == "mlaa") CHECK(off == 0);
        }
}
