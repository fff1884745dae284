// Required detail of a scene by its size: in pixels, in degrees, in kilometres.
#include <fmt/core.h>

#include "planets_fixture.h"

using namespace lightwalk;

TEST_CASE("penumbras in pixels: none in a portrait of Saturn, many where the Moon's shadow falls on the Earth",
          "[figures][17.penumbras]") {
    // Across the light a penumbra is as wide as the sun's disc after the shadow's way. A pixel of a portrait of 540 lines and
    // 26 degrees, so many radii away, is this wide.
    const auto pixel_m = [](double radius_m, double radii) {
        return radius_m * radii * 2 * std::tan(glm::radians(13.0)) / 540;
    };
    const double saturn_sun = glm::radians(0.056), r = 60268e3, pixel = pixel_m(r, 7.5);
    for (const double ring : {74658e3, 136775e3}) {  // in the plane of the rings, the sun 26.7 degrees above it
        const double wide = saturn_sun * ring * std::cos(glm::radians(26.7));
        fmt::print("penumbra on Saturn's rings at {:.0f} km: {:.0f} km, {:.2f} pixels\n", ring / 1e3, wide / 1e3,
                   wide / pixel);
        CHECK(wide / pixel < 0.5);
        // In texels of 15 km, as our strip has them, it is more than four.
        const Rings rings = rings_of(BodyId::saturn);
        CHECK(wide / (double(rings.outer - rings.inner) / 4096) > 4);
    }
    const double moon_away = 3.78e8, earth_sun = glm::radians(0.533);
    const double wide = earth_sun * moon_away, earth_pixel = pixel_m(6378137, 4.9);
    fmt::print("penumbra of the Moon on the Earth: {:.0f} km, {:.0f} pixels\n", wide / 1e3, wide / earth_pixel);
    CHECK(wide / earth_pixel > 100);
}

TEST_CASE("parallax in pixels: none of the Earth's mountains in its portrait, dozens from 400 km above",
          "[figures][17.parallax]") {
    // A summit of 8.8 km is moved by its height times the tangent of the angle at which it is seen: here 45 degrees.
    const double summit_m = 8849, portrait_m = 6378137 * 4.9 * 2 * std::tan(glm::radians(13.0)) / 540;
    const double low_m = 400e3 * std::sqrt(2.0) * 2 * std::tan(glm::radians(13.0)) / 540;
    // Of the colour maps, from which heights would have to be guessed: 2,048 texels around a planet.
    const double earth_texel_m = 2 * glm::pi<double>() * 6378137 / 2048,
                 mars_texel_m = 2 * glm::pi<double>() * 3396190 / 2048;
    fmt::print("parallax of a summit: {:.2f} pixels in the portrait, {:.0f} from 400 km\n", summit_m / portrait_m,
               summit_m / low_m);
    fmt::print("from 400 km a texel of the Earth's map: {:.0f} pixels\n", earth_texel_m / low_m);
    fmt::print("from 400 km a texel of Mars' map: {:.0f} pixels\n", mars_texel_m / low_m);
    CHECK(earth_texel_m / low_m > 2 * summit_m / low_m);
    CHECK(summit_m / portrait_m < 0.5);
    CHECK(summit_m / low_m > 10);
}

TEST_CASE(
    "radii and flattening are those of FACTS; so are Mercury's and Pluto's tilt and sun in the mean of an orbit") {
    const struct {
        BodyId body;
        double radius_km, flattening;
    } shapes[] = {{BodyId::mercury, 2440, 0},      {BodyId::venus, 6052, 0},         {BodyId::earth, 6378, 0.0034},
                  {BodyId::mars, 3396, 0.0059},    {BodyId::jupiter, 71492, 0.0649}, {BodyId::saturn, 60268, 0.0980},
                  {BodyId::uranus, 25559, 0.0229}, {BodyId::neptune, 24764, 0.0171}, {BodyId::pluto, 1188, 0}};
    for (const auto& shape : shapes) {
        INFO(body_names()[size_t(shape.body)]);
        CHECK(traits(shape.body).radius_m / 1e3 == Approx(shape.radius_km).margin(0.8));
        CHECK(traits(shape.body).flattening == Approx(shape.flattening).margin(1e-4));
    }
    for (const auto& [body, year, tilt, sun] :
         {std::tuple(BodyId::mercury, 87.97, 0.0, 1.377), std::tuple(BodyId::pluto, 90560.0, 122.5, 0.014)}) {
        glm::dvec3 orbit(0.0);
        double away = 0;
        for (int i = 0; i < 360; ++i) {
            const glm::dvec3 a = place_body(body, year * i / 360).position,
                             b = place_body(body, year * (i + 1) / 360).position;
            orbit += glm::cross(a, b);
            away += glm::length(a) / 360;
        }
        const double angle = glm::degrees(std::acos(glm::dot(glm::normalize(orbit), place_body(body, 0).axes[1])));
        fmt::print("{}: tilt {:.1f} degrees, sun {:.3f}\n", body_names()[size_t(body)], angle,
                   glm::degrees(2 * sun_radius_m / away));
        CHECK(angle == Approx(tilt).margin(4));
        CHECK(glm::degrees(2 * sun_radius_m / away) == Approx(sun).epsilon(0.08));
    }
}

TEST_CASE("Neptune's pole is where NASA's fact sheet has it, and circles about its mean", "[17.neptune_pole]") {
    // NASA's Neptune fact sheet: right ascension 299.33, declination 42.95 degrees at J2000.
    const glm::dvec3 pole = place_body(BodyId::neptune, 0).axes[1];
    CHECK(glm::degrees(std::acos(glm::dot(pole, direction_of(299.33, 42.95)))) < 0.02);
    const glm::dvec3 later = place_body(BodyId::neptune, 36525).axes[1];
    CHECK(glm::degrees(std::acos(std::min(glm::dot(pole, later), 1.0))) == Approx(0.45).margin(0.05));
}

// B. Archinal et al., "Report of the IAU Working Group on Cartographic Coordinates and Rotational Elements: 2015", 2018: W is the angle
// from the node of the body's equator on the Earth's to the prime meridian.
TEST_CASE("Neptune's prime meridian is the IAU's, also where its term is largest", "[17.neptune_pole]") {
    const auto meridian_deg = [](double days) {
        const glm::dmat3 axes = place_body(BodyId::neptune, days).axes;
        const glm::dvec3 node = glm::normalize(glm::cross(direction_of(0, 90), axes[1]));
        return glm::degrees(std::atan2(glm::dot(glm::cross(node, axes[2]), axes[1]), glm::dot(node, axes[2])));
    };
    for (const double n_deg : {357.85, 450.0, 630.0}) {  // at J2000; sin N is 1, and -1
        const double days = (n_deg - 357.85) / 52.316 * 36525;
        const double w = 249.978 + 541.1397757 * days - 0.48 * std::sin(glm::radians(n_deg));
        INFO(days);
        CHECK(std::fabs(std::remainder(meridian_deg(days) - w, 360.0)) < 1e-3);
    }
}

// The eclipse of 21 August 2017 from 50 radii on the Sun's side, a map of no Earth: nothing is shaded beyond the Moon's
// radius and the Sun's half angle.
TEST_CASE_METHOD(OnPlanets, "the Moon's penumbra on the Earth is as wide as the Sun's disc makes it", "[17.penumbra]") {
    const double earth_m = 6378e3, away_m = 50 * earth_m;
    glm::dvec3 earth(0.0), z(0.0);
    glm::dvec2 axis(1e30);
    for (double days = 6441.75; days < 6442.75; days += 1.0 / 256) {  // floats: 20 s are 600 km
        const glm::dvec3 place = place_body(BodyId::earth, days).position, to_sun = -glm::normalize(place);
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun));
        const glm::dvec3 moon = place_body(BodyId::moon, days).position - place;
        const glm::dvec2 off(glm::dot(moon, right), glm::dot(moon, glm::cross(to_sun, right)));
        if (glm::length(off) > glm::length(axis)) continue;
        axis = off;
        earth = place;
        z = to_sun;
        planets.date_days.value = float(days);
    }
    REQUIRE(glm::length(axis) < earth_m);
    look_at("pluto", 6);
    planets.exposed_for_m = glm::length(earth);
    exact_eye = earth + away_m * z;
    camera = {.position = {0, 0, 0}, .target = glm::vec3(-z), .fov_y_rad = 0.044f};
    size = {128, 128};
    const ImageRgb disc = picture();
    planets.shadow.set("hard");
    const ImageRgb hard = picture();
    const double pixel_m = away_m * std::tan(0.022) / 64;
    double widest = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const glm::dvec2 at = pixel_m * glm::dvec2(x - 63.5, 63.5 - y);
            const double ratio = double(disc.at(x, y).g) / double(hard.at(x, y).g);
            if (glm::length(at) < 0.97 * earth_m && std::fabs(ratio - 1) > 1e-3)
                widest = std::max(widest, glm::length(at - axis));
        }
    fmt::print("penumbra: {:.0f} km from its axis\n", widest / 1e3);
    CHECK(widest == Approx(1737e3 + 372e6 * std::sin(glm::radians(0.2635))).epsilon(0.04));
}

TEST_CASE("the edges of Saturn's rings are NASA's") {
    std::vector<double> edges;
    for (const RingPart& part : ring_parts(BodyId::saturn)) {
        edges.push_back(part.inner_m / 1e3);
        edges.push_back(part.outer_m / 1e3);
    }
    for (const double edge : {74658.0, 92000.0, 117580.0, 122170.0, 133423.0, 133745.0, 136775.0})
        CHECK(std::any_of(edges.begin(), edges.end(), [&](double e) { return std::fabs(e - edge) < 1; }));
    for (const RingPart& part : ring_parts(BodyId::saturn)) {
        const double r = part.inner_m / 1e3;
        if (r < 92000) CHECK((part.depth >= 0.05 && part.depth <= 0.12));           // C
        if (r >= 92000 && r < 117580) CHECK((part.depth >= 1 && part.depth <= 3));  // B
        if (r == 117580) CHECK(part.depth == Approx(0.1));                          // Cassini's division
    }
}

TEST_CASE("a strip of rings holds their depth, also of rings that are narrower than its texels") {
    const Rings rings = rings_of(BodyId::uranus);
    for (const int texels : {64, 1000, 4096}) {
        double held = 0, wanted = 0;
        for (const glm::vec4& texel : ring_strip(BodyId::uranus, texels))
            held += double(texel.a) * double(rings.outer - rings.inner) / texels;
        for (const RingPart& part : ring_parts(BodyId::uranus)) wanted += part.depth * (part.outer_m - part.inner_m);
        CHECK(held == Approx(wanted).epsilon(1e-5));
    }
}

TEST_CASE("a sphere in place of Saturn: its shadow is 8% too long, its normals are 5.9 degrees off",
          "[figures][17.saturn_sphere]") {
    const double r = 60268, f = 0.098, sun = glm::radians(26.7);
    const glm::dvec3 to_sun(0, std::sin(sun), std::cos(sun)), pole(0, 1, 0);
    // Where on the ring's plane, opposite to the sun, does the shadow end?
    const auto end = [&](double flattening) {
        double low = r, high = 4 * r;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (truth::ellipsoid_shadow({0, 0, -middle}, pole, r, flattening, to_sun, 1e-9, 2) < 0.5 ? low : high) =
                middle;
        }
        return low;
    };
    fmt::print("the shadow ends at {:.0f} km, a sphere's at {:.0f} km\n", end(f), end(0));
    CHECK(end(0) / end(f) == Approx(1.08).margin(0.005));
    CHECK(end(0) - end(f) == Approx(10400).margin(200));
    const auto tilt = [](double flattening) {
        double worst = 0;
        for (double b = 0; b < 1.57; b += 0.001) {
            const glm::dvec2 at(std::cos(b), (1 - flattening) * std::sin(b)),
                normal(std::cos(b), std::sin(b) / (1 - flattening));
            worst = std::max(worst, std::acos(std::min(1.0, glm::dot(glm::normalize(at), glm::normalize(normal)))));
        }
        return glm::degrees(worst);
    };
    CHECK(tilt(0.098) == Approx(5.9).margin(0.1));
    CHECK(tilt(0.0649) == Approx(3.8).margin(0.1));
}

TEST_CASE_METHOD(OnPlanets,
                 "Saturn's portrait shows whether its shadow is a ball's, and not whether the Sun is a disc") {
    size = {240, 160};
    look_at("saturn", 7.5, 34, 18);
    const auto by = [&](const char* shadow) {
        planets.shadow.set(shadow);
        return picture();
    };
    const ImageRgb disc = by("disc"), hard = by("hard"), sphere = by("sphere");
    const auto apart = [&](const ImageRgb& other) {
        double sum = 0;
        for (size_t i = 0; i < disc.pixels.size(); ++i)
            sum += std::fabs(double(other.pixels[i].g) - double(disc.pixels[i].g));
        return sum / sum_of(disc);
    };
    fmt::print("Saturn's shadow: a hard edge changes {:.5f} of the light, a ball's {:.5f}\n", apart(hard),
               apart(sphere));
    CHECK(apart(hard) > 0);
    CHECK(apart(sphere) > 5 * apart(hard));
}
