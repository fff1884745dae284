// Water from above and from below: where reflected rays meet the picture, and how much light is left at a depth.
#include <fmt/core.h>

#include <cmath>
#include <list>

#include "transparency_fixture.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

/// Radiance that deep water at a depth scatters towards the eye.
glm::dvec3 scattered(const OnWater& on, double depth_m) {
    const Sun sun = on.scene.sun();
    return glm::dvec3(on.water.turbid.value) * glm::exp(-depth_m * glm::dvec3(on.water.absorption.value)) *
           (glm::dvec3(sun.sky) + glm::dvec3(sun.light) * double(sun.to_sun.y) / glm::pi<double>());
}

/// Fresnel's reflectance of a surface seen at an angle, its mean over the facets that face the eye: slopes normally
/// distributed with that deviation on each axis, each facet weighted by the area that it shows.
double mean_fresnel(double tilt, double deviation) {
    double light = 0, area = 0;
    const int steps = 400;
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i) {
            const double x = 10 * ((i + 0.5) / steps - 0.5), z = 10 * ((j + 0.5) / steps - 0.5);
            const double shown = std::cos(tilt) - deviation * x * std::sin(tilt);  // of the area on the ground
            if (shown <= 0) continue;
            const double cosine = shown / std::sqrt(1 + deviation * deviation * (x * x + z * z));
            const double weight = shown * std::exp(-0.5 * (x * x + z * z));
            light += weight * truth::fresnel_exact(cosine, 1, 1.333);
            area += weight;
        }
    return light / area;
}

}  // namespace

TEST_CASE_METHOD(OnWater, "in the picture a reflected ray is halved until it misses what it meets by centimetres") {
    size = {24, 2048};
    camera.position = {0, 4, 0};
    camera.target = {0, 3, -20};
    water.roughness.value = 0;
    water.refraction.value = 0;
    // A wall 40 m away with light that grows with the height, in steps of 2.5 cm.
    Quads wall(owner, "steps");
    for (int i = 0; i < 480; ++i) {
        const float from = 0.025f * float(i), to = from + 0.025f;
        wall.quads.push_back(
            {{{-9, from, -40}, {9, from, -40}, {9, to, -40}, {-9, to, -40}}, {1 + from + 0.0125f, 0, 0, 1}});
    }
    wall.solid = uint32_t(wall.quads.size());
    const ImageRgb none = picture("flat", "none"), followed = picture("flat", "screen_space", 0, {wall});
    const ViewRays rays = view_rays(view_of(camera, size));
    int asked = 0;
    double sum = 0;
    for (int y = 0; y < int(size.y); ++y) {
        const glm::dvec3 ray = glm::normalize(glm::dvec3(ray_through(rays, glm::vec2(12.5f, float(y) + 0.5f))));
        const double to_water = -double(camera.position.y) / ray.y, high = -(40 + to_water * ray.z) / ray.z * -ray.y;
        if (ray.y >= 0 || high < 0.2 || high > 8) continue;
        const double share = truth::fresnel_water(-ray.y, 1, 1.333);
        const double found = double(followed.at(12, y).r - none.at(12, y).r) / share - 1;
        ++asked;
        sum += std::fabs(found - high);
    }
    fmt::print("{} rays end {:.1f} cm above or below what they should meet\n", asked, 100 * sum / asked);
    CHECK(asked > 400);
    CHECK(sum / asked < 0.012);
}

TEST_CASE_METHOD(OnWater,
                 "at a depth there is what the water above it has left of the light from the sky and the sun") {
    for (const float level : {0.0f, 3.0f})
        for (const float depth : {0.5f, 2.0f, 9.0f}) {
            water.level_m.value = level;
            camera.position = {0, level - depth, 0};
            camera.target = {0, level - depth - 2, -20};
            const glm::dvec3 right = scattered(*this, double(depth));
            const ImageRgb seen = picture("flat", "none");
            INFO("level " << level << ", depth " << depth);
            for (const int x : {3, 50, 90}) CHECK(glm::length(glm::dvec3(seen.at(x, 60)) / right - 1.0) < 0.01);
            // A wall 8 m away, through as much water.
            Wall wall(owner);
            wall.z = -8;
            wall.left = -90;
            wall.right = 90;
            wall.bottom = level - 90;
            wall.color = {2, 3, 4, 1};
            wall.top = level - depth;
            const ImageRgb behind = picture("flat", "none", 0, {wall});
            const glm::dvec3 ray(ray_through(view_rays(view_of(camera, size)), glm::vec2(40.5f, 60.5f)));
            const double way = 8 / -ray.z * glm::length(ray);
            const glm::dvec3 left = glm::exp(-way * glm::dvec3(water.absorption.value));
            CHECK(glm::length(glm::dvec3(behind.at(40, 60)) / (glm::dvec3(2, 3, 4) * left + right * (1.0 - left)) -
                              1.0) < 0.01);
        }
}

TEST_CASE_METHOD(OnWater, "in waves an eye is as deep as the surface above it is high") {
    water.waves.value = 3;
    water.slope.value = 0.2f;
    for (const float time_s : {0.5f, 2.5f, 4.0f}) {
        water.method.set("gerstner");
        const float height = water.height_above({0, 0}, double(time_s));
        CHECK(std::fabs(height) > 0.01f);
        camera.position = {0, height - 2, 0};
        camera.target = {0, height - 8, -20};
        const ImageRgb seen = picture("gerstner", "none", time_s);
        CHECK(glm::length(glm::dvec3(seen.at(50, 62)) / scattered(*this, 2) - 1.0) < 0.01);
    }
}

TEST_CASE_METHOD(OnWater, "rough water reflects what an integral over its visible facets says, within 0.05",
                 "[15.rough_water]") {
    scene.file.ambient = glm::vec3(1);
    scene.set_sun({.to_sun = {0, -1, 0}, .light = glm::vec3(0), .sky = glm::vec3(0)});
    owner.prepare_all(gpu, scene);
    size = {8, 64};
    camera.fov_y_rad = 0.03f;
    background = {0, 0, 0, 1};
    for (const double deviation : {0.02, 0.05, 0.1, 0.2})
        for (const double degrees : {60.0, 75.0, 80.0, 85.0}) {
            const double tilt = degrees * M_PI / 180;
            water.roughness.value = float(deviation);
            camera.position = {0, 5, 0};
            camera.target = {0, 0, float(-5 * std::tan(tilt))};
            const double found = double(picture("flat", "cube").at(4, 32).r), right = mean_fresnel(tilt, deviation);
            INFO(deviation << " at " << degrees << " degrees: " << found << " instead of " << right);
            CHECK(found == Approx(right).margin(0.05));
        }
}

TEST_CASE_METHOD(OnWater, "in a white furnace water sends out no more than arrives, by any method", "[15.furnace]") {
    scene.file.ambient = glm::vec3(1);
    background = glm::vec4(1);
    scene.set_sun({.to_sun = {0, -1, 0}, .light = glm::vec3(0), .sky = glm::vec3(1)});
    owner.prepare_all(gpu, scene);
    for (const char* method : {"flat", "sines", "gerstner", "fft"})
        for (const char* reflection : {"cube", "screen_space", "planar"})
            for (const float roughness : {0.0f, 0.1f, 0.5f})
                for (const float height : {2.0f, -1.0f}) {
                    water.roughness.value = roughness;
                    water.turbid.value = glm::vec3(1);
                    camera.position = {0, height, 0};
                    camera.target = {0, 0, -10};
                    float most = 0;
                    for (const glm::vec3& p : picture(method, reflection, 1.5f).pixels)
                        most = std::max({most, p.r, p.g});
                    INFO(method << " " << reflection << " " << roughness << " " << height << ": " << most);
                    CHECK(most < 1.005f);
                }
}

TEST_CASE_METHOD(OnWater, "water absorbs light on its way down, and back along the refracted ray", "[15.absorption]") {
    water.roughness.value = 0;
    water.refraction.value = 0;
    water.shore_m.value = 0;
    water.turbid.value = glm::vec3(0);
    water.absorption.value = {0.3f, 0.15f, 0.05f};
    scene.set_sun({.to_sun = {0, -1, 0}, .light = glm::vec3(0), .sky = glm::vec3(0)});
    owner.prepare_all(gpu, scene);
    Quads ground(owner, "ground");
    const float depth = 1.5f, far = 400;
    ground.quads = {
        {{{-far, -depth, far}, {far, -depth, far}, {far, -depth, -far}, {-far, -depth, -far}}, {1, 1, 1, 1}}};
    ground.solid = 1;
    for (const double degrees : {80.0, 45.0, 30.0, 10.0}) {
        const double sine = std::sin(degrees * M_PI / 180);
        camera.position = {0, 5, 0};
        camera.target = {0, 0, float(-5 / std::tan(degrees * M_PI / 180))};
        const double up = std::sqrt(1 - (1 - sine * sine) / (1.333 * 1.333));
        const glm::dvec3 left = glm::exp(-double(depth) * (1 + 1 / up) * glm::dvec3(water.absorption.value));
        const glm::dvec3 right = (1 - truth::fresnel_water(sine, 1, 1.333)) * left;
        camera.fov_y_rad = 0.01f;
        const glm::dvec3 seen(picture("flat", "none", 0, {ground}).at(48, 32));
        INFO(degrees << " degrees: " << seen.r << " " << seen.g << " instead of " << right.r << " " << right.g);
        CHECK(glm::length(seen / right - 1.0) < 0.02);
    }
}

TEST_CASE_METHOD(OnWater, "from below: the sky straight above, and past the critical angle the water alone") {
    water.roughness.value = 0;
    water.refraction.value = 0;
    water.absorption.value = glm::vec3(0);
    water.turbid.value = glm::vec3(0.2f, 0.05f, 0.01f);
    camera.up = {0, 0, -1};  // 63 degrees to the upper edge
    camera.fov_y_rad = 2.2f;
    camera.position = {0, -3, 0};
    camera.target = {0, 0, 0};
    const ImageRgb seen = picture("flat", "none");
    const glm::dvec3 water_light = scattered(*this, 3), sky(background);
    const ViewRays rays = view_rays(view_of(camera, size));
    for (uint32_t y = 1; y < size.y; y += 3)
        for (uint32_t x = 1; x < size.x; x += 3) {
            const glm::dvec3 ray = glm::normalize(glm::dvec3(ray_through(rays, glm::vec2(x, y) + 0.5f)));
            const double share = truth::fresnel_water(ray.y, 1.333, 1);
            INFO("cosine " << ray.y << ", reflected " << share);
            if (ray.y > std::sqrt(1 - 1 / (1.333 * 1.333)) + 0.01 || ray.y < std::sqrt(1 - 1 / (1.333 * 1.333)) - 0.01)
                CHECK(glm::length(glm::dvec3(seen.at(int(x), int(y))) - glm::mix(sky, water_light, share)) < 0.01);
        }
}

TEST_CASE_METHOD(OnWater, "the surroundings' cube is asked for by the reflections that show it, and by no other") {
    camera.position = {0, 5, 0};
    for (const char* reflection : {"none", "cube", "screen_space", "planar", "rays"}) {
        const auto in = [&](float ambient) {
            scene.file.ambient = glm::vec3(ambient);
            owner.prepare_all(gpu, scene);
            return picture("gerstner", reflection);
        };
        const bool differs = in(0.1f).pixels != in(2.0f).pixels;
        INFO(reflection);
        CHECK(water.sees_surroundings(view_of(camera, size)) == differs);
    }
    // Where no mirror image is drawn, the cube stands in for it.
    water.reflection.set("planar");
    camera.position = {0, -1, 0};
    CHECK(water.sees_surroundings(view_of(camera, size)));
    water.method.set("none");
    CHECK(!water.sees_surroundings(view_of(camera, size)));
}
