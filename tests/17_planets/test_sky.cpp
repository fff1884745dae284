// What stands before what: bodies before the sky and behind walls, stars on the edges of a picture.
#include <fmt/core.h>

#include "planets_fixture.h"

using namespace lightwalk;

namespace {

/// The sky alone, looked at in directions of the catalogue.
struct OnSky : OnPlanets {
    OnSky() {
        planets.at.set("neptune");
        owner.prepare_all(gpu, scene);
        with_stars = true, with_planets = false;
        exact_eye = glm::dvec3(0.0);
        camera.position = glm::vec3(0.0f), camera.up = {0.1f, 0.9f, 0.2f};
    }
    void look_to(double right_ascension_deg, double declination_deg) {
        camera.target = glm::vec3(direction_of(right_ascension_deg, declination_deg));
    }
};

}  // namespace

TEST_CASE_METHOD(OnSky, "a part of the sky's picture is that part, with the images of stars beyond its edges") {
    stars.milky_way.value = 0, stars.sigma.value = 0.02f, camera.fov_y_rad = 0.9f;
    look_to(84, -1);  // Orion's belt
    size = {96, 64};
    const ImageRgb whole = picture();
    crop.whole = size, size = {20, 16};
    for (const glm::uvec2 corner : {glm::uvec2(0, 0), {38, 24}, {41, 27}, {52, 36}, {76, 48}}) {
        crop.origin = corner;
        const ImageRgb part = picture();
        double worst = 0;
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x)
                worst = std::max(worst,
                                 double(glm::length(part.at(x, y) - whole.at(x + int(corner.x), y + int(corner.y)))));
        INFO(corner.x << " " << corner.y);
        CHECK(worst < 1e-3);
    }
    CHECK(sum_of(whole) > 10);
}

TEST_CASE_METHOD(OnPlanets,
                 "a dark planet hides the sky by its disc, also where that is a few pixels wide; a wall hides it") {
    planets.exposure.value = 0, stars.brightness.value = 0, stars.milky_way.value = 400;
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
        with_stars = false, planets.exposure.value = 1;
        CHECK(sum_of(picture()) > 0);
        wall = 0.5f;
        CHECK(sum_of(picture()) == 0);
        wall = 0, with_stars = true, planets.exposure.value = 0;
    }
}
