// The figures that the lesson quotes, printed: build/tests/test_10_atmosphere "[figures]". And bounds on them.
#include <fmt/core.h>

#include "atmosphere_fixture.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

double luminance(glm::dvec3 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

std::string rgb(glm::dvec3 c) { return fmt::format("{:.3f} {:.3f} {:.3f}", c.r / c.b, c.g / c.b, 1.0); }

}  // namespace

TEST_CASE_METHOD(OnAtmosphere,
                 "light scattered more than once: tables against random walks, and what single scattering lacks",
                 "[figures]") {
    struct Case {
        const char* name;
        float elevation;
        glm::vec3 from, to;
    };
    const Case cases[] = {{"noon, half way up", 50, {0, 2, 0}, {0, 1002, -1000}},
                          {"sunset, towards the horizon", 3, {0, 2, 0}, {0, 150, -1000}},
                          {"sunset, zenith", 3, {0, 2, 0}, {0, 1002, -100}},
                          {"from 400 km, down", 30, {0, 4e5f, 0}, {0, 0, -1e5f}}};
    for (const Case& one : cases) {
        size = {12, 9};
        camera.fov_y_rad = 0.3f;
        look(one.from, one.to);
        atmosphere.sun_elevation_deg.value = one.elevation;
        atmosphere.sun_azimuth_deg.value = 90;
        atmosphere.paths.value = 192;
        atmosphere.orders.set("multiple");
        const glm::dvec3 walks = mean(picture("truth")), tables = mean(picture("tables"));
        const double doubt = mean(read_linear(gpu, atmosphere.doubt())).r / std::sqrt(double(size.x * size.y));
        atmosphere.orders.set("single");
        const glm::dvec3 once = mean(picture("truth"));
        const double off = luminance(tables) / luminance(walks) - 1, lacks = 1 - luminance(once) / luminance(walks);
        fmt::print(
            "{:28} tables {:+.1f}% of the walks' light (these are sure to {:.1f}%); single scattering lacks {:.0f}%\n",
            one.name, 100 * off, 100 * doubt, 100 * lacks);
        INFO(one.name);
        CHECK(std::fabs(off) < 0.06);
        CHECK(lacks > 0.05);
        CHECK(lacks < 0.6);
    }
}

TEST_CASE_METHOD(OnAtmosphere, "the standard error of random walks falls with the root of their number",
                 "[figures][10.standard_error]") {
    atmosphere.orders.set("multiple");
    size = {16, 12};
    look({0, 2, 0}, {0, 1002, -1000});
    const ImageRgb right = picture("tables");
    const auto doubts_of = [&](int paths) {
        atmosphere.paths.value = paths;
        const ImageRgb found = picture("truth"), doubts = read_linear(gpu, atmosphere.doubt());
        double square = 0, said = 0;
        for (size_t i = 0; i < right.pixels.size(); ++i) {
            const glm::dvec3 a(found.pixels[i]), b(right.pixels[i]);
            square += std::pow((a.r + a.g + a.b) / (b.r + b.g + b.b) - 1, 2);
            said += std::pow(double(doubts.pixels[i].r), 2);
        }
        const double n = double(right.pixels.size());
        fmt::print("{} walks: a pixel's standard error is {:.2f}%, that of all pixels about the tables {:.2f}%\n",
                   paths, 100 * std::sqrt(said / n), 100 * std::sqrt(square / n));
        return glm::dvec2(std::sqrt(said / n), std::sqrt(square / n));
    };
    const glm::dvec2 few = doubts_of(16), many = doubts_of(256);
    CHECK(few.y / many.y == Approx(4).epsilon(0.4));
    CHECK(many.x == Approx(many.y).epsilon(0.3));
}

TEST_CASE_METHOD(OnAtmosphere,
                 "the zenith's luminance and colour beside Preetham's, which were fitted to measured skies",
                 "[figures]") {
    size = {4, 4};
    camera.fov_y_rad = 0.05f;
    look({0, 2, 0}, {0, 2000, -1});
    atmosphere.exposure.value = 1;  // kcd/m²
    atmosphere.orders.set("multiple");
    for (const float elevation : {10.0f, 30.0f, 50.0f, 70.0f}) {
        atmosphere.sun_elevation_deg.value = elevation;
        const glm::dvec3 found = mean(picture("tables"));
        // Of measured clear skies, at Linke's turbidity (G. Ward's gensky of Radiance takes 2.75 for them).
        const auto measured = [&](double linke) {
            return (1.376 * linke - 1.81) * std::tan(glm::radians(double(elevation))) + 0.38;
        };
        glm::dvec3 fitted[2];
        for (const int turbidity : {2, 3}) {
            atmosphere.turbidity.value = float(turbidity);
            fitted[turbidity - 2] = mean(picture("preetham"));
        }
        fmt::print(
            "sun at {:2.0f}: zenith {:.2f} kcd/m², red green blue {}; measured {:.2f} to {:.2f}; Preetham's at "
            "turbidity 2 {:.2f} ({}), at 3 "
            "{:.2f} ({})\n",
            elevation, luminance(found), rgb(found), measured(2), measured(2.75), luminance(fitted[0]), rgb(fitted[0]),
            luminance(fitted[1]), rgb(fitted[1]));
        CHECK(luminance(found) > 0.6 * measured(2));
        CHECK(luminance(found) < 1.3 * measured(2.75));
        CHECK(luminance(fitted[0]) > 2 * luminance(found));  // Preetham's zenith is too bright
        CHECK(found.b > found.g);
        CHECK(found.g > found.r);
    }
}

TEST_CASE_METHOD(OnAtmosphere,
                 "methods against the truth: more places are better, tables best; O'Neil's fit is not mended by more",
                 "[figures]") {
    size = {32, 24};
    look({0, 100, 0}, {0, 300, -1000});
    atmosphere.sun_elevation_deg.value = 4;
    const ImageRgb right = picture("truth");
    const auto off = [&](const std::string& method, int steps, int light) {
        atmosphere.steps.value = steps;
        atmosphere.light_steps.value = light;
        const double found = relative_error(picture(method), right).mean;
        atmosphere.steps.value = 16;
        fmt::print("sunset, {:10} {:2} places on the path, {:2} towards the sun: light is off by {:.2f}%\n", method,
                   steps, light, 100 * found);
        return found;
    };
    for (const std::string method : {"polynomial", "chapman"})
        for (const int steps : {2, 4, 8, 16, 32, 64}) off(method, steps, 8);
    CHECK(off("polynomial", 64, 8) > 0.2);
    CHECK(off("chapman", 64, 8) < 0.03);
    CHECK(off("march", 64, 8) > 2 * off("march", 64, 64));
    CHECK(off("march", 16, 32) > off("march", 64, 32));
    CHECK(off("tables", 16, 8) < 0.01);
}

TEST_CASE_METHOD(OnAtmosphere, "tables are made once, and again when the air changes, not when the sun moves",
                 "[10.kept_tables]") {
    picture("tables");
    CHECK(atmosphere.tables_made == 1);
    CHECK(atmosphere.skies_made == 1);
    camera.target.y += 0.1f;  // the sky's table knows the eye's height and the sun, not where one looks
    picture("tables");
    CHECK(atmosphere.skies_made == 1);
    camera.position.y += 50;
    picture("tables");
    CHECK(atmosphere.skies_made == 2);
    atmosphere.sun_elevation_deg.value = 12;
    picture("tables");
    CHECK(atmosphere.tables_made == 1);
    CHECK(atmosphere.skies_made == 3);
    atmosphere.mie_height_m.value = 2000;
    const ImageRgb changed = picture("tables");
    CHECK(atmosphere.tables_made == 2);
    CHECK(relative_error(changed, picture("truth")).mean < 0.03);
    atmosphere.refresh.set("always");
    picture("tables");
    CHECK(atmosphere.tables_made == 3);
    atmosphere.table_scale.value = 0.5f;
    atmosphere.refresh.set("changed");
    picture("tables");
    CHECK(atmosphere.tables_made == 4);
}
