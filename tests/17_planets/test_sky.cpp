// Depth order: bodies before the sky and behind walls, stars on the edges of a picture.
#include <fmt/core.h>

#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/gpu/gpu_work.h"
#include "common/gpu/warm_up.h"
#include "common/scene/image_pool.h"
#include "common/scene/scene_file.h"
#include "planets_fixture.h"

using namespace lightwalk;

namespace {

/// The sky alone, looked at in directions of the catalogue.
struct OnSky : OnPlanets {
    OnSky() {
        planets.at.set("neptune");
        owner.prepare_all(gpu, scene);
        with_stars = true;
        with_planets = false;
        exact_eye = glm::dvec3(0.0);
        camera.position = glm::vec3(0.0f);
        camera.up = {0.1f, 0.9f, 0.2f};
    }
    void look_to(double right_ascension_deg, double declination_deg) {
        camera.target = glm::vec3(direction_of(right_ascension_deg, declination_deg));
    }
};

}  // namespace

TEST_CASE_METHOD(OnSky, "a part of the sky's picture is that part, with the images of stars beyond its edges") {
    stars.milky_way.value = 0;
    stars.sigma.value = 0.02f;
    camera.fov_y_rad = 0.9f;
    look_to(84, -1);  // Orion's belt
    size = {96, 64};
    const ImageRgb whole = picture();
    crop.whole = size;
    size = {20, 16};
    for (const glm::uvec2 corner : {glm::uvec2(0, 0), {38, 24}, {41, 27}, {52, 36}, {76, 48}}) {
        crop.origin = corner;
        const ImageRgb part = picture();
        double worst = 0;
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double right = double(whole.at(x + int(corner.x), y + int(corner.y))[c]);
                    worst = std::max(worst, std::fabs(double(part.at(x, y)[c]) - right) / std::max(1.0, right));
                }
        INFO(corner.x << " " << corner.y);
        CHECK(worst < 1e-3);  // a step of a half float is 2^-10 of its value at most
    }
    CHECK(sum_of(whole) > 10);
}

namespace {

// World space, of galactic coordinates by the definition of J2000: the north pole at 192.85948°, 27.12825°; the
// celestial pole's longitude is 122.93192°.
glm::dvec3 galactic_direction(double longitude, double latitude) {
    const double pole = glm::radians(27.12825), from = glm::radians(122.93192) - longitude;
    const double declination =
        std::asin(std::sin(latitude) * std::sin(pole) + std::cos(latitude) * std::cos(pole) * std::cos(from));
    const double past =
        std::atan2(std::cos(latitude) * std::sin(from),
                   std::sin(latitude) * std::cos(pole) - std::cos(latitude) * std::sin(pole) * std::cos(from));
    return direction_of(192.85948 + glm::degrees(past), glm::degrees(declination));
}

}  // namespace

// Half a texel off, in the map or in the picture's pixels, a pixel has the mean of two texels.
TEST_CASE_METHOD(OnSky, "the middle of a pixel that looks at the middle of the Milky Way's texel has its colour") {
    stars.brightness.value = 0;
    stars.milky_way.value = 1;
    const DecodedTexture map = decode_texture(find_asset("planets_2k/stars.jpg"), TextureKind::color);
    const uint32_t level = 5, columns = map.desc.size.x >> level, rows = map.desc.size.y >> level;
    // A pixel as wide as a texel of that level.
    size = {9, 9};
    camera.fov_y_rad = float(2 * std::atan(0.5 * size.y * glm::pi<double>() / rows));
    const auto texel = [&](uint32_t column, uint32_t row) {
        uint64_t halves = 0;
        std::memcpy(&halves, &map.levels.at(level)[8 * (row * columns + column % columns)], 8);
        return glm::dvec3(glm::unpackHalf4x16(halves));
    };
    double off = 0, shifted = 0;
    for (uint32_t row = 3; row < rows - 3; row += 5)
        for (uint32_t column = 1; column < columns; column += 7) {
            const double turn = glm::two_pi<double>();  // longitude grows to the left, from the middle
            camera.target = glm::vec3(
                galactic_direction(turn * (0.5 - (column + 0.5) / columns), 0.5 * turn * (0.5 - (row + 0.5) / rows)));
            const glm::dvec3 seen(picture().at(4, 4)), right = texel(column, row);
            off += glm::length(seen - right);
            for (const glm::dvec3& next : {texel(column + 1, row), texel(column, row + 1)})
                shifted += 0.5 * glm::length(0.5 * (next - right));
        }
    fmt::print("the Milky Way: {:.4f} off in all, {:.4f} if it lay half a texel elsewhere\n", off, shifted);
    CHECK(off < 0.3 * shifted);
}

TEST_CASE_METHOD(OnPlanets,
                 "a dark planet hides the sky by its disc, also where that is a few pixels wide; a wall hides it") {
    planets.exposure.value = 0;
    stars.brightness.value = 0;
    stars.milky_way.value = 400;
    with_stars = true;
    look_at("mercury", 6);
    const double radius = traits(BodyId::mercury).radius_m,
                 pixel = 2 * std::tan(0.5 * double(camera.fov_y_rad)) / size.y;
    for (const double diameter_px : {1.0, 3.0, 12.0}) {
        camera.position = glm::normalize(camera.position) * float(2 * radius / (diameter_px * pixel));
        with_planets = false;
        const ImageRgb sky = picture();
        with_planets = true;
        const ImageRgb hidden = picture();
        const double share = (sum_of(sky) - sum_of(hidden)) / double(sky.at(int(size.x) / 2, int(size.y) / 2).g);
        const double right = 0.25 * glm::pi<double>() * diameter_px * diameter_px;
        fmt::print("a disc of {} px hides {:.2f} pixels, its area is {:.2f}\n", diameter_px, share, right);
        CHECK(share == Approx(right).epsilon(0.06));
        with_stars = false;
        planets.exposure.value = 1;
        CHECK(sum_of(picture()) > 0);
        wall = 0.5f;
        CHECK(sum_of(picture()) == 0);
        wall = 0;
        with_stars = true;
        planets.exposure.value = 0;
    }
}

TEST_CASE_METHOD(OnPlanets, "no sky shines through a disc of twenty pixels") {
    planets.exposure.value = 0;
    stars.brightness.value = 0;
    stars.milky_way.value = 400;
    with_stars = true;
    look_at("mercury", 6);
    const double pixel = 2 * std::tan(0.5 * double(camera.fov_y_rad)) / size.y;
    camera.position = glm::normalize(camera.position) * float(2 * traits(BodyId::mercury).radius_m / (20 * pixel));
    const ImageRgb found = picture();
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 0; x < int(size.x); ++x)
            if (glm::length(glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(size)) < 8.5f) CHECK(found.at(x, y).g == 0);
}

TEST_CASE_METHOD(OnPlanets, "a planet hides the Sun behind it, and only where it is wider") {
    planets.exposure.value = 0;
    const double sun_deg = 0.35;  // at Mars, about
    for (const double radii : {3.0, 3000.0}) {
        look_at("mars", radii, 180);
        const bool hidden = 2 * glm::degrees(std::asin(1 / radii)) > sun_deg;
        CHECK((sum_of(picture()) == 0) == hidden);
    }
}

TEST_CASE_METHOD(OnPlanets, "a planet behind the camera hides nothing of the sky") {
    planets.exposure.value = 0;
    stars.milky_way.value = 400;
    with_stars = true;
    look_at("mercury", 1.001);
    camera.target = 2.0f * camera.position;
    const ImageRgb seen = picture();
    with_planets = false;
    CHECK(seen.pixels == picture().pixels);
}

// In a film the Sun came into the picture and its pipeline was built then: 74 ms.
TEST_CASE_METHOD(OnPlanets, "an unseen picture builds what bodies need that come nearer or into the picture later") {
    look_at("earth", 4, 30);
    {
        const WarmUp later;
        picture();
    }
    const uint64_t before = gpu_work.pipelines;
    for (const float fov_y_rad : {0.45f, 0.05f})  // the Sun is 1 and 12 pixels wide
        for (const double phase_deg : {30.0, 90.0, 180.0, 181.0, 270.0})
            for (const double radii : {1.5, 4.0, 1000.0}) {
                camera.fov_y_rad = fov_y_rad;
                look_at("earth", radii, phase_deg);
                picture();
            }
    CHECK(gpu_work.pipelines == before);
}
