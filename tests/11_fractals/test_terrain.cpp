// Where terrain goes wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include <cmath>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "11_fractals/terrain.h"
#include "11_fractals/truth.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

struct OnTerrain : OnModules {
    Terrain terrain{owner, "terrain"};
    Scene scene;
    Camera camera{.position = {0, 140, 0}, .target = {0, 100, -1000}, .near_m = 1, .far_m = 60000};
    glm::uvec2 size{96, 54};

    OnTerrain() {
        terrain.prepare(gpu, scene);
        terrain.cells.value = 32;
        terrain.rings.value = 6;
        terrain.spacing_m.value = 4;
        scene.file.lights = {Light{.direction = {0.7f, -0.4f, 0.5f}}};
    }
    void draw(float time_s = 0) { draw_frame(view_of(camera, size), terrain, time_s); }
    /// Pixels that show no ground.
    int holes() {
        int count = 0;
        for (const float depth : read<float>(frame.depth)) count += depth == 0;
        return count;
    }
};

}  // namespace

TEST_CASE_METHOD(OnTerrain, "the flight: place of the grid and rest add up to the way, and no vertex slides",
                 "[11.flight]") {
    for (const float km : {0.0f, -512.0f, 10000.0f}) {
        terrain.start_x_km.value = km;
        for (const float time_s : {0.0f, 0.1f, 33.3f, 4000.0f}) {
            draw(time_s);
            const TerrainNow& now = terrain.now();
            const glm::dvec2 flight = terrain.flight_m(camera, double(time_s));
            const glm::dvec2 middle =
                (glm::dvec2(now.cell) + glm::dvec2(now.offset)) * double(terrain.wave_m);  // cells are few enough here
            const glm::dvec2 eye = middle + glm::dvec2(double(now.eye.x), double(now.eye.z));
            CHECK(glm::length(eye - flight) < 2e-3);
            for (int i = 0; i < 2; ++i) {
                const double steps = middle[i] / double(terrain.spacing_m);
                CHECK(std::fabs(steps - std::round(steps)) < 1e-3);
                CHECK(std::fabs(i ? now.eye.z : now.eye.x) <= terrain.spacing_m);
            }
        }
    }
}

// What follows surfaces over frames knows the view alone: a point of the ground, found by the depth of one frame, is by the
// views where the next frame draws it.
TEST_CASE_METHOD(OnTerrain, "the flight moves the view, by which the ground of one frame is found in the next",
                 "[11.flight_view]") {
    struct Seen {
        View view;
        std::vector<float> depth;
    };
    const auto fly_to = [&](float time_s) {
        const World::Eye eye = terrain.eye(camera, time_s);
        View view = view_of(eye.camera, size);
        view.exact_eye = eye.exact;
        draw_frame(view, terrain, time_s);
        return Seen{view, read<float>(frame.depth)};
    };
    const Seen now = fly_to(10), then = fly_to(10.5f);
    CHECK(glm::length(*then.view.exact_eye * glm::dvec3(1, 0, 1) - *now.view.exact_eye * glm::dvec3(1, 0, 1) -
                      glm::dvec3(0, 0, -30)) < 1e-6);  // 60 m/s towards -z
    const glm::dmat4 to_place = glm::inverse(glm::dmat4(now.view.view_projection)),
                     to_then = glm::dmat4(then.view.view_projection);
    int found = 0, compared = 0;
    for (uint32_t y = size.y / 2; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const double depth = double(now.depth[y * size.x + x]);
            if (depth <= 0) continue;
            const glm::dvec2 at = 2.0 * (glm::dvec2(x, y) + 0.5) / glm::dvec2(size) - 1.0;
            const glm::dvec4 place = to_place * glm::dvec4(at, depth, 1.0);
            const glm::dvec3 world = glm::dvec3(place) / place.w + *now.view.exact_eye;
            const glm::dvec4 clip = to_then * glm::dvec4(world - *then.view.exact_eye, 1.0);
            const glm::dvec2 pixel = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * glm::dvec2(size);
            if (clip.w <= 0 || glm::any(glm::lessThan(pixel, glm::dvec2(0))) ||
                glm::any(glm::greaterThanEqual(pixel, glm::dvec2(size))))
                continue;
            const double seen = double(then.depth[size_t(pixel.y) * size.x + size_t(pixel.x)]), due = clip.z / clip.w;
            ++compared;
            found += std::fabs(seen / due - 1) < 0.1;
        }
    INFO(found << " of " << compared);
    CHECK(compared > 500);
    CHECK(found > 0.9 * compared);
}

TEST_CASE_METHOD(OnTerrain, "the ground that the camera follows is the truth's, to a millimetre") {
    Random random(21);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 at(random.uniform(-30000, 30000), random.uniform(-30000, 30000));
        const truth::Ground right = truth::eroded_truth(NoisePlace::at(at / double(terrain.wave_m)), 4,
                                                        double(terrain.erosion), double(terrain.gain));
        CHECK(std::fabs(terrain.ground_m(at, 4) - double(terrain.height_m) * right.height) < 1e-3);
    }
}

TEST_CASE_METHOD(OnTerrain, "the eye stays above the ground for 100 km") {
    double least = 1e9;
    for (double way = 0; way < 1e5; way += 50) {
        const double eye = terrain.ground_m({0, -way}, 4) + 140;
        least = std::min(least, eye - terrain.ground_m({0, -way}, 11));
    }
    fmt::print("least height above the ground in 100 km: {:.0f} m\n", least);
    CHECK(least > 20);
}

TEST_CASE_METHOD(OnTerrain, "between rings of different density there are cracks, unless they are stitched",
                 "[11.cracks]") {
    camera = {.position = {0, 900, 0}, .target = {1, 0, 0}, .up = {0, 0, -1}, .near_m = 1, .far_m = 60000};
    camera.target = {100, 100, -300};
    size = {480, 270};
    terrain.octaves.set("fixed");  // rough to the last
    terrain.show.set("normals");
    int cracks = 0;
    for (const float z : {0.0f, 3.0f, 9.0f}) {
        terrain.start_z_km.value = z;
        terrain.stitch.value = false;
        draw();
        cracks += holes();
        terrain.stitch.value = true;
        for (const char* octaves : {"footprint", "fixed"}) {
            terrain.octaves.set(octaves);
            draw();
            CHECK(holes() == 0);
        }
    }
    fmt::print("cracks: {} pixels of three pictures show no ground\n", cracks);
    CHECK(cracks > 20);
}

TEST_CASE_METHOD(OnTerrain,
                 "every choice gives numbers: sun at the zenith, at the horizon, below it; no height, no waves") {
    for (const glm::vec3 direction : {glm::vec3{0, -1, 0}, {1, 0, 0}, {1, 0.2f, 0}})
        for (const char* shadow : {"none", "smooth", "marched"}) {
            scene.file.lights[0].direction = direction;
            terrain.shadow.set(shadow);
            draw();
            const ImageRgb picture = read_linear(gpu, frame.hdr);
            for (const glm::vec3& pixel : picture.pixels)
                CHECK((std::isfinite(pixel.r + pixel.g + pixel.b) && pixel.g >= 0));
        }
    terrain.method.set("central");
    terrain.height_m.value = 0;
    draw();
    for (const glm::vec3& pixel : read_linear(gpu, frame.hdr).pixels) CHECK(std::isfinite(pixel.r + pixel.g + pixel.b));
}

TEST_CASE_METHOD(OnTerrain, "octaves by footprint: the nearer, the more; fixed: all of them everywhere") {
    terrain.show.set("octaves");
    camera.target = {0, -100, -1000};
    draw();
    const ImageRgb seen = read_linear(gpu, frame.hdr);
    double top = 0, bottom = 0;
    for (uint32_t x = 0; x < size.x; ++x) {
        bottom += double(seen.at(int(x), int(size.y) - 1).g);
        top += double(seen.at(int(x), int(size.y) / 2).g);
    }
    CHECK(bottom > top);
    CHECK(bottom / size.x < 1.0);
    terrain.octaves.set("fixed");
    draw();
    CHECK(read_linear(gpu, frame.hdr).at(48, 50).g == 1.0f);
}

TEST_CASE_METHOD(OnTerrain, "the smoother ground's light, against a ray to the sun for every pixel",
                 "[figures][11.soft_light]") {
    const auto picture = [&](const char* shadow) {
        terrain.shadow.set(shadow);
        draw();
        return read_linear(gpu, frame.hdr);
    };
    terrain.fog.method.set("none");
    terrain.start_x_km.value = 22;
    terrain.start_z_km.value = 66;
    for (const float elevation_deg : {4.0f, 8.0f, 16.0f, 32.0f}) {
        scene.file.lights[0].direction = {1, -std::tan(glm::radians(elevation_deg)), 0.3f};
        const ImageRgb right = picture("marched"), low = picture("smooth"), none = picture("none");
        double off_low = 0, off_none = 0, all = 0;
        for (size_t i = 0; i < right.pixels.size(); ++i) {
            off_low += std::fabs(double(low.pixels[i].g - right.pixels[i].g));
            off_none += std::fabs(double(none.pixels[i].g - right.pixels[i].g));
            all += double(right.pixels[i].g);
        }
        fmt::print(
            "sun {} degrees high: of all light {:.1f}% is wrong without a shadow, {:.1f}% with the smoother "
            "ground's\n",
            elevation_deg, 100 * off_none / all, 100 * off_low / all);
        if (elevation_deg < 10) CHECK(off_low < off_none);
        CHECK(off_none > 0);
    }
}

TEST_CASE_METHOD(OnTerrain,
                 "the light of the sky is bluer on slopes that face away from the sun; a back light adds to them",
                 "[figures][11.back_light]") {
    terrain.fog.method.set("none");
    terrain.shadow.set("none");
    camera.target = {0, -100, -1000};
    const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-0.9, 0.24, -0.25));  // as in the scene of the shot `peak`
    scene.file.lights[0].direction = glm::vec3(-to_sun);
    Probe probe{.include = "10_atmosphere/preetham.glsl",
                .signature = "vec3 preetham_sky(vec3 direction, vec3 to_sun, float turbidity)"};
    for (const double side : {-1.0, 1.0}) {  // slopes of 45 degrees, away from the sun and towards it
        const glm::dvec3 level = glm::normalize(glm::dvec3(to_sun.x, 0, to_sun.z)),
                         n = side * level + glm::dvec3(0, 1, 0);
        const glm::dvec3 seen = glm::normalize(glm::dvec3(n.x, 1.5 * std::sqrt(2.0), n.z));  // as terrain_color() asks
        probe.inputs.push_back({seen.x, seen.y, seen.z, to_sun.x, to_sun.y, to_sun.z, 2.4});
    }
    const Table sky = run_probe(gpu, probe, 3);
    const double away = sky[0][2] / sky[0][0], towards = sky[1][2] / sky[1][0];
    fmt::print("sky, blue over red on a slope of 45 degrees away from the sun: {:.1f}\n", away);
    fmt::print("sky, blue over red on a slope of 45 degrees towards the sun: {:.1f}\n", towards);
    CHECK(away > 1.2 * towards);

    const auto picture = [&](const char* shown, float back_light, float noise) {
        terrain.show.set(shown);
        terrain.back_light.value = back_light;
        terrain.ambient_noise.value = noise;
        draw();
        return read_linear(gpu, frame.hdr);
    };
    const ImageRgb plain = picture("picture", 0, 0), lit = picture("picture", 1, 0),
                   noisy = picture("picture", 0, 0.5f);
    const ImageRgb normals = picture("normals", 0, 0);
    const double flat = std::hypot(to_sun.x, to_sun.z), tangent = std::tan(glm::radians(30.0));
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(-to_sun.x, tangent * flat, -to_sun.z));
    glm::dvec3 sum(0), gained(0), moved(0), changed(0);
    for (size_t i = 0; i < plain.pixels.size(); ++i) {
        const glm::dvec3 before(plain.pixels[i]), more = glm::dvec3(lit.pixels[i]) - before;
        const double facing = glm::dot(2.0 * glm::dvec3(normals.pixels[i]) - 1.0, to_light);
        if (facing < -0.01) CHECK(more == glm::dvec3(0));
        if (facing > 0.05) CHECK(more.b > 0);
        sum += before;
        gained += more;
        changed += glm::dvec3(noisy.pixels[i]) - before;
        moved += glm::abs(glm::dvec3(noisy.pixels[i]) - before);
    }
    CHECK(gained.b / sum.b > 1.5 * gained.r / sum.r);
    fmt::print("ambient noise of 0.5 changes a pixel by {:.3f} and the mean by {:.3f}\n", moved.g / sum.g,
               changed.g / sum.g);
    CHECK(moved.g > 0.01 * sum.g);
    CHECK(std::fabs(changed.g) < 0.5 * moved.g);
}
