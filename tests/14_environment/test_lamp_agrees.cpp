// A lamp and an environment of equal light on the same ball.
#include <fmt/format.h>
#include <unistd.h>

#include <functional>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "14_environment/lit_around.h"
#include "14_environment/truth.h"

using namespace lightwalk;

namespace {

struct Balls : OnModules {
    ImageLight light{owner, "environment"};
    LitAround objects{owner, "objects", light};
    Scene scene;  // keeps the patch, once it is read
    std::filesystem::path patch =
        std::filesystem::temp_directory_path() / fmt::format("lightwalk_patch_{}.pfm", getpid());

    ~Balls() { std::filesystem::remove(patch); }

    ImageRgb picture(const SceneFile& file) {
        scene.load(gpu, file, [](const auto& path) { return load_model(path, Loader::parallel); });
        owner.prepare_all(gpu, scene);
        const View view = view_of(scene.file.camera, {48, 48});
        begin(view.size);
        light.record(frame, scene);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(0));
        lightwalk::draw(frame, view, canvas, {objects});
        frame.end();
        return read_linear(gpu, frame.hdr);
    }

    /// A picture of `radiance`, by direction, and its integral over all directions.
    double write_picture(const std::function<double(glm::dvec3)>& radiance) {
        ImageRgb picture(2048, 1024);
        double sum = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const glm::dvec3 d = truth::direction_at({(x + 0.5) / picture.width, (y + 0.5) / picture.height});
                const auto value = static_cast<float>(radiance(d));
                picture.at(x, y) = glm::vec3(value);
                sum += double(value) * truth::equirect_solid_angle(y, picture.width, picture.height);
            }
        write_pfm(patch, picture);
        scene.images(gpu).clear();
        return sum;
    }

    /// A picture that is dark but for a spot about `middle`, and the irradiance over pi that it sends to what faces it.
    double write_patch(glm::dvec3 middle, double sigma_rad) {
        return write_picture([&](glm::dvec3 d) {
                   const double away = std::acos(std::clamp(glm::dot(d, middle), -1.0, 1.0)) / sigma_rad;
                   return away < 5 ? 2000 * std::exp(-0.5 * away * away) : 0.0;
               }) /
               (0.5 * truth::around);
    }
};

}  // namespace

TEST_CASE_METHOD(Balls, "a ball under a lamp is the ball under a small patch of equal light", "[14.lamp_agrees]") {
    // The middle of a texel of the cube's level of 16 × 16, from which irradiance is summed: elsewhere the patch would move.
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(5.0 / 16, 7.0 / 16, 1));
    light.method.set("truth");
    objects.maps.surface.model.set("ggx");
    objects.maps.lamps.samples.value = 1024;
    SceneFile file;
    file.camera = {.position = {0, 0, 3}, .target = {0, 0, 0}, .fov_y_rad = 0.8f, .near_m = 0.1f, .far_m = 10};
    file.objects = {{.name = "ball", .parent = {}, .model = "models/sphere.obj"}};
    file.objects[0].material.diffuse = glm::vec3(0.9f, 0.6f, 0.3f);
    file.environment.image = patch;
    double white = 0;
    for (const float roughness : {0.2f, 0.5f, 0.8f})
        for (const float metalness : {1.0f, 0.0f}) {
            // The smoothest ball's lobe is no wider than what its samples resolve: there the patch is wider, and so is the
            // lamp, a disc of the same variance.
            const bool is_smooth = roughness < 0.3f;
            const double sigma_rad = glm::radians(is_smooth ? 0.75 : 0.25);
            if (metalness > 0 && roughness < 0.6f) white = write_patch(to_light, sigma_rad);
            objects.maps.lamps.method.set(is_smooth ? "sampled" : "point");
            file.objects[0].material.roughness = roughness;
            file.objects[0].material.metalness = metalness;
            light.intensity.value = 1;
            file.lights = {};
            const ImageRgb around = picture(file);
            light.intensity.value = 0;
            file.lights = {{.intensity = float(white), .direction = -glm::vec3(to_light)}};
            file.lights[0].size_rad = float(4 * sigma_rad);
            const ImageRgb lamp = picture(file);
            double sum = 0, off = 0, most = 0;
            for (const glm::vec3& pixel : lamp.pixels) most = std::max(most, double(pixel.g));
            for (size_t i = 0; i < lamp.pixels.size(); ++i) {
                const double a = lamp.pixels[i].g, b = around.pixels[i].g;
                if (is_smooth && a < 0.02 * most) continue;  // beyond the lobe too few samples meet the patch
                sum += a;
                off += std::abs(a - b);
            }
            // The lamp's body and what several microfacets send go by view and light, the environment's by the view
            // alone. So far apart are the two on this ball, by the published formulas and the table in double precision.
            const double apart = metalness > 0      ? (is_smooth          ? 0.004
                                                       : roughness < 0.6f ? 0.021
                                                                          : 0.042)
                                 : is_smooth        ? 0.047
                                 : roughness < 0.6f ? 0.017
                                                    : 0.007;
            CAPTURE(metalness, roughness, sum, most, off / sum);
            CHECK(sum > 1);
            CHECK(off / sum < apart + 0.015);
        }
}

// A small lamp meets few samples, and each of these reads a level that is wider than the lamp. Share of the light that is
// out of place, against 2,048 samples of the sharp cube.
TEST_CASE_METHOD(Balls, "a prefiltered cube shows a small lamp wider, the fewer its samples",
                 "[14.small_lamp][figures]") {
    objects.maps.surface.model.set("ggx");
    SceneFile file;
    file.camera = {.position = {0, 0, 3}, .target = {0, 0, 0}, .fov_y_rad = 0.8f, .near_m = 0.1f, .far_m = 10};
    file.objects = {{.name = "ball", .parent = {}, .model = "models/sphere.obj"}};
    file.objects[0].material.diffuse = glm::vec3(1);
    file.objects[0].material.metalness = 1;
    file.objects[0].material.roughness = 0.5f;
    file.environment.image = patch;
    write_patch(glm::normalize(glm::dvec3(0.3, 0.4, 1)), glm::radians(0.5));
    light.method.set("prefiltered");
    light.prefilter.samples.value = 2048;
    light.prefilter.bias.value = 0;
    const ImageRgb right = picture(file);
    light.prefilter.bias.value = 1;
    double before = 0.5;
    for (const int samples : {16, 64, 256}) {
        light.prefilter.samples.value = samples;
        const ImageRgb found = picture(file);
        double off = 0, sum = 0;
        for (size_t i = 0; i < found.pixels.size(); ++i) {
            off += std::abs(double(found.pixels[i].g) - double(right.pixels[i].g));
            sum += double(right.pixels[i].g);
        }
        fmt::print("small lamp, {} samples: off by {:.3f}\n", samples, off / sum);
        CHECK(off / sum < before);
        before = off / sum;
    }
    CHECK(before < 0.2);
}

// From the middle of one texel of the level from which irradiance is summed to the middle of the next.
TEST_CASE_METHOD(Balls, "a small sun that moves over a texel lights a surface by its cosine", "[14.small_sun]") {
    SceneFile file;
    file.camera = {.position = {0, 0, 3}, .target = {0, 0, 0}, .fov_y_rad = 0.8f, .near_m = 0.1f, .far_m = 10};
    file.objects = {{.name = "ball", .parent = {}, .model = "models/sphere.obj"}};
    file.objects[0].material.diffuse = glm::vec3(1);
    file.environment.image = patch;
    light.method.set("none");
    std::vector<double> shares;  // of what its cosine sends, by the surface that faces the camera
    for (int step = 0; step <= 4; ++step) {
        const glm::dvec3 to_light = glm::normalize(glm::dvec3((5 + 0.5 * step) / 16, 7.0 / 16, 1));
        const double white = write_patch(to_light, glm::radians(0.25));
        shares.push_back(double(picture(file).pixels[24 * 48 + 24].g) / (white * to_light.z));
        fmt::print("small sun, {} of a texel: {:.4f}\n", 0.25 * step, shares.back());
    }
    const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
    CHECK(*least > 0.5);
    CHECK(*most < 1.03 * *least);
}

// Nothing hides the sky from a floor: neither its diffuse light nor what it reflects may darken, however it is seen.
TEST_CASE_METHOD(Balls, "screen-space occlusion leaves an open floor as it is, at every tilt and roughness",
                 "[14.open_floor]") {
    write_picture([](glm::dvec3 d) { return std::max(d.y, 0.0) * (2 + d.x); });
    SceneFile file;
    file.environment.image = patch;
    file.objects = {{.name = "floor", .parent = {}, .model = "models/plane.obj"}};
    file.objects[0].scale = glm::vec3(40);
    file.objects[0].material.diffuse = glm::vec3(0.5f);
    for (const float height : {0.3f, 1.0f, 3.0f, 9.0f}) {
        file.camera = {.position = {0, height, 3}, .target = {0, 0, 0}, .fov_y_rad = 0.3f, .near_m = 0.1f, .far_m = 50};
        double worst = 0;
        for (const float roughness : {0.1f, 0.4f, 0.7f, 1.0f}) {
            file.objects[0].material.roughness = roughness;
            objects.occlusion.set("none");
            const ImageRgb open = picture(file);
            objects.occlusion.set("screen_space");
            const ImageRgb found = picture(file);
            for (size_t i = 0; i < open.pixels.size(); ++i)
                if (open.pixels[i].g > 0)  // below the horizon
                    worst = std::max(worst, std::abs(double(found.pixels[i].g / open.pixels[i].g) - 1));
            CHECK(open.pixels[24 * 48 + 24].g > 0.1f);
        }
        fmt::print("open floor, seen from {} m: occlusion changes its light by up to {:.5f}\n", double(height), worst);
        CHECK(worst < 0.003);
    }
}

// A ball of radius r on a floor, under a sky that is as bright as it is high. What rays find of it, on average over the
// floor, is the integral over directions that miss the ball, whatever the number of samples.
TEST_CASE_METHOD(Balls, "occlusion by rays does not depend on the number of samples", "[14.rays_unbiased]") {
    const auto sky = [](glm::dvec3 d) { return std::max(d.y, 0.0); };
    write_picture(sky);
    const double radius = 0.5;
    SceneFile file;
    file.camera = {
        .position = {1.2f, 2.5f, 1.2f}, .target = {0, 0.2f, 0}, .fov_y_rad = 0.9f, .near_m = 0.1f, .far_m = 50};
    file.objects = {{.name = "floor", .parent = {}, .model = "models/plane.obj"},
                    {.name = "ball", .parent = {}, .model = "models/sphere.obj"}};
    file.objects[0].scale = glm::vec3(40);
    file.objects[0].material.diffuse = glm::vec3(1);
    file.objects[1].position = {0, float(radius), 0};
    file.objects[1].scale = glm::vec3(float(2 * radius));
    file.environment.image = patch;
    light.method.set("none");
    objects.occlusion.set("rays");
    const auto expected = [&](glm::dvec3 place) {
        const glm::dvec3 to_ball = glm::dvec3(0, radius, 0) - place;
        const int turns = 256, rises = 64;
        double sum = 0;
        for (int i = 0; i < turns * rises; ++i) {
            const double turn = truth::around * (i % turns + 0.5) / turns, y = (i / turns + 0.5) / rises,
                         across = std::sqrt(1 - y * y);
            const glm::dvec3 d(across * std::cos(turn), y, across * std::sin(turn));
            const double along = glm::dot(to_ball, d);
            if (along < 0 || glm::dot(to_ball, to_ball) - along * along > radius * radius) sum += sky(d) * y;
        }
        return sum * 2 / (turns * rises);  // over pi
    };
    for (const int samples : {16, 512}) {
        light.samples.value = samples;
        const ImageRgb found = picture(file);
        const View view = view_of(file.camera, {48, 48});
        const ViewRays rays = view_rays(view);
        double right = 0, off = 0, square = 0, count = 0;
        for (uint32_t i = 0; i < 48 * 48; ++i) {
            const glm::dvec3 eye = rays.eye, ray = ray_through(rays, glm::vec2(i % 48, i / 48) + 0.5f);
            const glm::dvec3 place = eye - ray * (eye.y / ray.y), from = eye - glm::dvec3(0, radius, 0);
            const double b = glm::dot(from, ray), a = glm::dot(ray, ray);
            const double away = std::sqrt(glm::dot(from, from) - b * b / a);
            if (away < 1.1 * radius || glm::length(place) > 2) continue;
            const double exact = expected(place), seen = double(found.pixels[i].g);
            right += exact;
            off += seen - exact;
            square += (seen - exact) * (seen - exact);
            ++count;
        }
        fmt::print("{} rays: {} pixels, off by {:.4f} of the light on average, RMS {:.4f}\n", samples, count,
                   off / right, std::sqrt(square / count));
        CHECK(count > 500);
        CHECK(std::abs(off / right) < 0.01);
    }
}

// glTF 2.0, 3.9.4: alpha is coverage. What is seen is alpha of the opaque surface and the rest of the background, whatever
// the surface reflects, glows or is.
TEST_CASE_METHOD(Balls, "alpha is the share of the background that a surface covers", "[14.coverage]") {
    write_patch(glm::normalize(glm::dvec3(0.2, 1, 0.3)), 0.3);
    SceneFile file;
    file.camera = {.position = {0, 1, 0.6f}, .target = {0, 0, 0}, .fov_y_rad = 0.5f, .near_m = 0.1f, .far_m = 10};
    file.environment.image = patch;
    file.lights = {{.intensity = 0.4f, .direction = glm::normalize(glm::vec3(-0.3f, -1, -0.1f))}};
    file.objects = {{.name = "plane", .parent = {}, .model = "models/plane.obj"}};
    file.objects[0].material.roughness = 0.1f;
    for (const float glow : {0.0f, 1.0f}) {
        file.objects[0].material.emissive = glm::vec3(glow);
        file.objects[0].material.opacity = 1.0f;
        const ImageRgb solid = picture(file);
        file.objects[0].material.opacity = 0.0f;
        const ImageRgb nothing = picture(file);
        for (const float alpha : {0.25f, 0.6f}) {
            file.objects[0].material.opacity = alpha;
            const ImageRgb found = picture(file);
            for (const size_t i : {size_t(24 * 48 + 24), size_t(30 * 48 + 10), size_t(16 * 48 + 36)}) {
                INFO("glow " << glow << ", alpha " << alpha << ", pixel " << i);
                CHECK(nothing.pixels[i].g == 0);  // the background of this canvas
                CHECK(solid.pixels[i].g > 0.01f);
                CHECK(found.pixels[i].g == Approx(double(alpha * solid.pixels[i].g)).epsilon(0.005));
            }
        }
    }
}
