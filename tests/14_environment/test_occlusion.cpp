// Occlusion of what is seen against form factors, on depths of planes that are intersected here.
#include <fmt/core.h>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "14_environment/lit_around.h"

using namespace lightwalk;

namespace {

/// A floor at y = 0, and on it a wall `height_m` high along x at z = 0, which hides what lies behind it.
struct OnOcclusion : OnModules {
    ScreenOcclusion occlusion{owner, "screen_occlusion"};
    Image depth;
    double height_m = 1;
    glm::uvec2 size{320, 180};
    std::vector<uint64_t> found;
    View view;
    double pole_m = 0;  ///< a square pole of this width stands before the wall, at z = 0.5
    double ball_m = 0;  ///< a ball of this radius lies on the floor, above the origin

    /// Distance along the ray, which is 1 long along the view; 0 where nothing is.
    double hit(glm::dvec3 eye, glm::dvec3 ray) const {
        double nearest = 1e30;
        if (ray.y < 0) nearest = -eye.y / ray.y;
        if (ray.z < 0) {
            const double wall = -eye.z / ray.z, pole = (0.5 - eye.z) / ray.z;
            const glm::dvec3 on_wall = eye + wall * ray, on_pole = eye + pole * ray;
            if (on_wall.y >= 0 && on_wall.y <= height_m) nearest = std::min(nearest, wall);
            if (std::abs(on_pole.x) < 0.5 * pole_m && on_pole.y >= 0) nearest = std::min(nearest, pole);
        }
        const glm::dvec3 from = eye - glm::dvec3(0, ball_m, 0);
        const double a = glm::dot(ray, ray), b = glm::dot(from, ray),
                     inside = b * b - a * (glm::dot(from, from) - ball_m * ball_m);
        if (ball_m > 0 && inside > 0) nearest = std::min(nearest, (-b - std::sqrt(inside)) / a);
        return nearest < 1e29 ? nearest : 0;
    }
    void draw(Camera camera) {
        view = view_of(camera, size);
        const ViewRays rays = view_rays(view);
        std::vector<float> stored;
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x) {
                const double t = hit(rays.eye, ray_through(rays, glm::vec2(x, y) + 0.5f));
                stored.push_back(t > 0 ? float((1 / t - rays.inverse_far) / (rays.inverse_near - rays.inverse_far))
                                       : 0.0f);
            }
        depth.ensure(gpu.device, {.name = "depth", .format = VK_FORMAT_R32_SFLOAT, .size = size});
        begin(size);
        frame.upload("depth", depth, std::as_bytes(std::span(stored)));
        occlusion.record(frame, view, depth);
        frame.end();
        found = read<uint64_t>(occlusion.image());
    }
    glm::vec4 at(glm::dvec3 place) const {  // of the pixel in which it is seen
        const glm::vec4 clip = view.view_projection * glm::vec4(glm::vec3(place), 1.0f);
        const glm::vec2 pixel = (0.5f * glm::vec2(clip) / clip.w + 0.5f) * glm::vec2(size);
        return glm::unpackHalf4x16(found[size_t(pixel.y) * size.x + size_t(pixel.x)]);
    }
};

const Camera above{.position = {0, 2.2f, 3.5f}, .target = {0, 0.3f, 0.4f}};

}  // namespace

TEST_CASE_METHOD(OnOcclusion, "an even floor is not hidden, from whatever angle it is seen") {
    height_m = -1;
    occlusion.radius_m.value = 2;
    for (const float height : {0.3f, 1.0f, 3.0f}) {
        draw({.position = {0, height, 3}, .target = {0, 0, 0}});
        double least = 1, bent = 0;
        for (int i = -8; i <= 8; ++i)
            for (const double z : {-1.0, 0.0, 1.0}) {
                least = std::min(least, double(at({0.1 * i, 0, z}).w));
                bent = std::max(bent, double(glm::length(glm::vec3(at({0.1 * i, 0, z})))));
            }
        fmt::print("even floor, seen from {} m: least visibility {:.4f}, bent by {:.4f}\n", double(height), least,
                   bent);
        CHECK(least > 0.999);
        CHECK(bent < 0.001);
    }
}

// A wall that goes on to both sides hides (1 - cos a) / 2 of a cosine-weighted hemisphere, tan a = height / distance (the form
// factor of an infinite strip, H. C. Hottel's crossed strings, 1954).
TEST_CASE_METHOD(OnOcclusion, "below a wall: the visibility is that of its form factor") {
    occlusion.radius_m.value = 20;
    occlusion.thickness.value = 0;
    occlusion.slices.value = 16;
    occlusion.steps.value = 32;
    double worst = 0;
    for (const double z : {0.15, 0.3, 0.6, 1.0, 1.5}) {
        draw(above);
        const double exact = 1 - 0.5 * (1 - z / std::hypot(height_m, z));
        const glm::vec4 open = at({0, 0, z});
        fmt::print("{} m from a wall of 1 m: visibility {:.3f}, exact {:.3f}\n", z, double(open.w), exact);
        worst = std::max(worst, std::abs(double(open.w) - exact));
        CHECK(open.z > 0.0f);  // bent away from it
        CHECK(std::abs(open.x) < 0.15f * open.w);
    }
    CHECK(worst < 0.08);
}

TEST_CASE_METHOD(OnOcclusion, "more slices and steps come nearer to the form factor", "[figures][14.more_slices]") {
    occlusion.radius_m.value = 20;
    occlusion.thickness.value = 0;
    const auto error = [&](int slices, int steps) {
        occlusion.slices.value = slices;
        occlusion.steps.value = steps;
        draw(above);
        double square = 0, count = 0;
        for (int i = -10; i <= 10; ++i)
            for (const double z : {0.15, 0.3, 0.6, 1.0, 1.5}) {
                const double off = double(at({0.05 * i, 0, z}).w) - (0.5 + 0.5 * z / std::hypot(height_m, z));
                square += off * off;
                ++count;
            }
        fmt::print("{} slices, {} steps: error {:.3f}\n", slices, steps, std::sqrt(square / count));
        return std::sqrt(square / count);
    };
    double before = 1;
    for (const glm::ivec2 many :
         {glm::ivec2(1, 2), glm::ivec2(2, 4), glm::ivec2(3, 6), glm::ivec2(8, 12), glm::ivec2(16, 32)}) {
        const double now = error(many.x, many.y);
        CHECK(now < before);
        if (many.y == 6) CHECK(now < 0.15);  // six steps for 20 m
        before = now;
    }
    for (const float thickness : {0.0f, 0.1f}) {
        occlusion.thickness.value = thickness;
        before = 1;
        for (const int steps : {4, 8, 16, 64}) {
            const double now = error(16, steps);
            CHECK(now < before);
            before = now;
        }
    }
}

// A ball of radius r on a floor hides r²/D² cos of a point whose distance from its middle is D, and cos = r/D. A depth buffer
// does not show the gap between ball and floor: in the limit of many slices and steps, all is hidden from the first direction
// on, away from the eye, that meets the ball. More steps come nearer to that limit.
TEST_CASE_METHOD(OnOcclusion, "a ball on a floor: more steps come nearer to what a depth buffer shows of it",
                 "[14.ball_on_floor]") {
    occlusion.radius_m.value = 10;
    occlusion.slices.value = 16;
    occlusion.thickness.value = 0;
    height_m = -1;
    ball_m = 0.5;
    const glm::dvec3 middle(0, ball_m, 0);
    const auto limit = [&](glm::dvec3 place, glm::dvec3 eye) {
        const glm::dvec3 to_eye = glm::normalize(eye - place),
                         side = glm::normalize(glm::cross(to_eye, glm::dvec3(0, 1, 0)));
        double open = 0;
        const int turns = 256, angles = 512;
        for (int i = 0; i < turns; ++i) {
            const double turn = 2 * M_PI * (i + 0.5) / turns;
            const glm::dvec3 along = std::cos(turn) * side + std::sin(turn) * glm::cross(side, to_eye);
            for (int j = 0; j < angles; ++j) {
                const double a = M_PI * (j + 0.5) / angles;
                const glm::dvec3 ray = std::cos(a) * to_eye + std::sin(a) * along, away = middle - place;
                const double towards = glm::dot(away, ray);
                if (towards > 0 && glm::dot(away, away) - towards * towards < ball_m * ball_m) break;
                open += std::max(ray.y, 0.0) * std::sin(a) * (2 * M_PI / turns) * (M_PI / angles) / M_PI;
            }
        }
        return open;
    };
    // RMS distances: from the limit, from the ball's form factor, and between these two.
    const auto errors = [&](int steps) {
        occlusion.steps.value = steps;
        draw({.position = {0, 2.2f, 3.5f}, .target = {0, 0.3f, 0}});
        const glm::dvec3 eye = view_rays(view).eye;
        glm::dvec3 squares(0);
        double count = 0;
        for (int i = 0; i < 32; ++i)
            for (const double away : {0.3, 0.45, 0.6, 0.9, 1.2}) {
                const glm::dvec3 place(away * std::cos(0.2 * i), 0, away * std::sin(0.2 * i));
                if (hit(eye, place - eye) < 0.999) continue;  // behind the ball
                const double seen = double(at(place).w), exact = 1 - std::pow(ball_m / std::hypot(away, ball_m), 3),
                             shown = limit(place, eye);
                const glm::dvec3 off(seen - shown, seen - exact, shown - exact);
                squares += off * off;
                ++count;
            }
        const glm::dvec3 error = glm::sqrt(squares / count);
        fmt::print(
            "ball on a floor, {}x{}, {} steps: {:.4f} from the limit, {:.4f} from its form factor, which are "
            "{:.4f} apart\n",
            size.x, size.y, steps, error.x, error.y, error.z);
        CHECK(count > 80);
        return error;
    };
    double before = 1;
    for (const int steps : {4, 8, 16, 64}) {
        const double now = errors(steps).x;
        CHECK(now < before + 0.002);
        before = now;
    }
    CHECK(before < 0.04);
    // What is left is the pixels' size: depths are read at their middles.
    size = {640, 360};
    const double finer = errors(64).x;
    CHECK(finer < 0.7 * before);
}

TEST_CASE_METHOD(OnOcclusion,
                 "failures: a thin pole darkens like a wall, and what is outside of the picture hides nothing",
                 "[figures]") {
    occlusion.radius_m.value = 1.5f;
    occlusion.slices.value = 8;
    occlusion.steps.value = 16;
    height_m = 3;
    pole_m = 0.04;
    const auto beside_pole = [&](float thickness) {
        occlusion.thickness.value = thickness;
        draw({.position = {0, 1, 4}, .target = {0, 1, 0}});
        return double(at({0.15, 1, 0}).w);
    };
    const double solid = beside_pole(0), thin = beside_pole(0.5f);
    pole_m = 0;
    const double none = beside_pole(0);
    fmt::print(
        "wall beside a pole of 4 cm, 50 cm in front: {:.3f} without thickness, {:.3f} with 0.5, {:.3f} without pole\n",
        solid, thin, none);
    CHECK(solid < none - 0.02);
    CHECK(thin > solid);
    // The foot of the wall lies below the border of the picture: nothing darkens where it should be half dark.
    occlusion.thickness.value = 0;
    draw({.position = {0, 2.4f, 2}, .target = {0, 2.0f, 0}});
    const double border =
        double(found.empty() ? 0.0f : glm::unpackHalf4x16(found[(size.y - 1) * size.x + size.x / 2]).w);
    fmt::print("wall at the lower border of the picture, its foot outside: {:.3f}\n", border);
    CHECK(border > 0.9);
}
