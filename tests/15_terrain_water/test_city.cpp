// A city: its shadows and its reflections, against rays through its boxes.
#include <fmt/core.h>

#include <cmath>

#include "15_terrain_water/shore.h"
#include "15_terrain_water/sun_shadow.h"
#include "land_fixture.h"

using namespace lightwalk;

namespace {

// The lake and the plain of lake_city.json, coarser, with fewer houses.
struct OnCity : OnLand {
    City city{owner, "city", ground, atmosphere};
    SunShadow sun_shadow{owner, "sun_shadow", atmosphere};
    ImageLight light{owner, "environment"};
    Water water{owner, "water", light};
    ReflectedRays reflected{owner, "reflected", ground, land, city, atmosphere};
    CityPlan plan{.middle_m = {-1000, -700}, .radius_m = 700, .towers_m = 120, .most_boxes = 3000, .seed = 1};

    OnCity() {
        size = {160, 90};
        ground.levels.value = 8;
        ground.span_km.value = 14;
        ground.center_x_km.value = 6;
        ground.center_z_km.value = 6;
        ground.datum_m.value = 322;
        ground.height_scale.value = 1.6f;
        ground.detail_m.value = 0;
        ground.plain_km.value = {5, 5.3f, 1.5f};
        ground.plain_m.value = 4;
        city.x_km.value = -1;
        city.z_km.value = -0.7f;
        city.radius_km.value = 0.7f;
        city.towers_m.value = 120;
        city.most_boxes.value = 3000;
        land.shadow.set("none");
        land.method.set("rays");
        atmosphere.sun_elevation_deg.value = 30;
        atmosphere.sun_azimuth_deg.value = 110;
        sun_shadow.maps.distance_m.value = 3000;
        sun_shadow.maps.bias_m.value = 0.1f;
        sun_shadow.maps.resolution.value = 2048;
        light.radiance_alone = true;  // as Shore has it
        water.tracer = &reflected;
        water.method.set("none");
        load("terrain/jacksboro_dem.png");
    }
    ImageRgb picture(const Drawings& solid) {
        begin(size);
        const View view = view_of(camera, size);
        atmosphere.update_once(frame);
        ground.record(frame, false);
        sun_shadow.record(frame, view, scene, {land, city});
        light.record(frame, scene);
        Drawings all = solid;
        all.push_back(water);
        water.reflect(frame, view, all);
        Canvas canvas(frame.hdr, frame.depth);
        lightwalk::draw(frame, view, canvas, all);
        frame.end();
        return read_linear(gpu, frame.hdr);
    }
    // Whether a house of the plan, on ground of 4 m, stands on the way to the sun.
    bool is_shaded(const std::vector<CityBox>& boxes, glm::dvec3 from) const {
        const glm::dvec3 to_sun(atmosphere.to_sun());
        for (const CityBox& box : boxes) {
            const double c = std::cos(double(box.yaw)), s = std::sin(double(box.yaw));
            const auto own = [&](glm::dvec3 v) { return glm::dvec3(c * v.x - s * v.z, v.y, s * v.x + c * v.z); };
            const glm::dvec3 half(box.half_size);
            const glm::dvec3 middle(box.place.x, 4 + double(box.base_m) + half.y, box.place.y);
            const glm::dvec3 at = own(from - middle), along = own(to_sun);
            double enters = 0, leaves = 1e9;
            for (int i = 0; i < 3; ++i) {
                const double a = (-half[i] - at[i]) / along[i], b = (half[i] - at[i]) / along[i];
                enters = std::max(enters, std::min(a, b));
                leaves = std::min(leaves, std::max(a, b));
            }
            if (enters < leaves) return true;
        }
        return false;
    }
};

double grey(const glm::vec3& p) { return double(p.r + p.g + p.b) / 3; }

}  // namespace

TEST_CASE_METHOD(OnCity, "houses shade the ground where a ray to the sun meets one", "[15.house_shadows]") {
    std::vector<CityBox> boxes;
    plan_city(plan, boxes);
    camera.position = {-1000, 700, -300};
    camera.target = {-1000, 0, -700};
    camera.fov_y_rad = 0.7f;
    const ImageRgb lit = [&] {
        sun_shadow.maps.method.set("none");
        return picture({land});
    }();
    sun_shadow.maps.method.set("pcf");
    const ImageRgb shaded = picture({land});
    const auto bytes = gpu.read_back(land.found());
    const ViewRays rays = view_rays(view_of(camera, size));
    int asked = 0, wrong = 0, dark = 0;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const size_t i = size_t(y) * size.x + x;
            float found = 0;
            std::memcpy(&found, bytes.data() + 4 * i, 4);
            const glm::dvec3 at(rays.eye + found * ray_through(rays, glm::vec2(x, y) + 0.5f));
            if (found <= 0 || std::fabs(at.y - 4) > 0.2 || glm::length(at - glm::dvec3(-1000, 4, -700)) > 500) continue;
            const bool right = is_shaded(boxes, at);
            bool edge = false;  // the map's filter is some metres wide
            for (const glm::dvec3 beside :
                 {glm::dvec3(4, 0, 0), glm::dvec3(-4, 0, 0), glm::dvec3(0, 0, 4), glm::dvec3(0, 0, -4)})
                edge |= is_shaded(boxes, at + beside) != right;
            if (edge) continue;
            const bool is_dark = grey(shaded.pixels[i]) < 0.75 * grey(lit.pixels[i]);
            ++asked;
            wrong += is_dark != right;
            dark += right;
        }
    fmt::print("{} of {} places in the shadow of houses, {} wrong\n", dark, asked, wrong);
    CHECK(dark > asked / 10);
    CHECK(dark < asked);
    CHECK(wrong < 0.02 * asked);
}

TEST_CASE_METHOD(OnCity, "no sun, no shadow: nothing is drawn at night, nor without houses") {
    camera.position = {-1000, 700, -300};
    camera.target = {-1000, 0, -700};
    atmosphere.sun_elevation_deg.value = -8;
    picture({land});
    CHECK(!sun_shadow.exists());
    atmosphere.sun_elevation_deg.value = 30;
    city.most_boxes.value = 0;
    picture({land});
    CHECK(!sun_shadow.exists());
    city.most_boxes.value = 3000;
    picture({land});
    CHECK(sun_shadow.exists());
    CHECK(sun_shadow.maps.drawn_views > 0);
    picture({land});
    CHECK(sun_shadow.maps.drawn_views == 0);  // nothing has moved
    city.plan_seed.value = 2;
    picture({land});
    CHECK(sun_shadow.maps.drawn_views > 0);
}

TEST_CASE_METHOD(OnCity, "rays from level water find what the mirror image shows", "[15.level_rays]") {
    camera.position = {350, 22, 900};
    camera.target = {-800, 60, -500};
    camera.fov_y_rad = 0.63f;
    water.method.set("flat");
    water.mirror.scale.value = 1;
    water.roughness.value = 0;
    water.refraction.value = 0;
    const auto by = [&](const char* reflection) {
        water.reflection.set(reflection);
        return picture({land, city});
    };
    // Where the mirror image has something: its sky is black here.
    const auto off = [&](const char* what) {
        const ImageRgb none = by("none"), planar = by("planar"), rays = by("rays");
        double sum = 0, wrong = 0;
        size_t pixels = 0;
        for (size_t i = 0; i < none.pixels.size(); ++i) {
            const double right = grey(planar.pixels[i]) - grey(none.pixels[i]);
            if (right < 0.01) continue;
            sum += right;
            wrong += std::fabs(grey(rays.pixels[i]) - grey(planar.pixels[i]));
            ++pixels;
        }
        fmt::print("{}: {} pixels reflect; by rays {:.1f}% of their light is wrong\n", what, pixels, 100 * wrong / sum);
        CHECK(pixels > 300);
        return wrong / sum;
    };
    CHECK(off("houses and hills") < 0.08);  // edges, and windows at another distance
    city.most_boxes.value = 0;
    CHECK(off("hills") < 0.06);
}
