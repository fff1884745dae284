// Checks of chapter 18: rays, drags, turns, and the image of numbers.
#include <fmt/core.h>

#include <cmath>

#include "01_obj/camera_view.h"
#include "18_playground/exercises.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

std::string text(const glm::vec3& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }
bool is_unit(const glm::vec3& v, double within = 1e-5) { return std::fabs(double(glm::length(v)) - 1) < within; }

}  // namespace

CHECK_EXERCISE(
    "18.pick_ray",
    "Two points behind the pixel, at depth 1 and at 0.5, each divided by its own w; the ray goes on from the first.") {
    Random random(1);
    for (int i = 0; i < 80; ++i) {
        const bool turned = i % 4 == 3, infinite = i % 2;
        Camera camera;
        camera.position = i < 4 ? glm::vec3(0, 0, 3) : 20.0f * random.direction();
        camera.target = i < 4 ? glm::vec3(0) : 3.0f * random.direction();
        camera.up = turned ? random.direction() : glm::vec3(0, 1, 0);
        camera.far_m = infinite ? INFINITY : 500.0f;
        camera.near_m = i % 5 ? 0.05f : 1.5f;
        const glm::uvec2 size = i % 3 ? glm::uvec2(960, 540) : glm::uvec2(200, 700);
        const View view = view_of(camera, size);
        const glm::vec2 px(random.uniform(0, size.x), random.uniform(0, size.y));
        const glm::dmat4 back(glm::mat4(glm::inverse(glm::dmat4(view.view_projection))));  // as floats hold it
        const auto at = [&](double depth) {
            const glm::dvec4 place = back * glm::dvec4(2.0 * glm::dvec2(px) / glm::dvec2(size) - 1.0, depth, 1);
            return glm::dvec3(place) / place.w;
        };
        const glm::dvec3 origin = at(1), direction = glm::normalize(at(0.5) - origin);
        const std::string what =
            fmt::format("pick_ray(a camera with its far plane {}, the place ({:.1f}, {:.1f}) of {}x{} pixels)",
                        infinite ? "at infinity" : "at 500 m", px.x, px.y, size.x, size.y);
        check.call(what, [&]() -> std::string {
            const PickRay ray = pick_ray(glm::mat4(back), px, size);
            for (int c = 0; c < 3; ++c)
                if (!std::isfinite(ray.origin[c]) || !std::isfinite(ray.direction[c]))
                    return what + " is no number: at the far plane w may be 0";
            if (!is_unit(ray.direction))
                return fmt::format("{}: the direction has the length {:.4g}, expected 1", what,
                                   glm::length(ray.direction));
            const double cosine = glm::dot(glm::dvec3(ray.direction), direction);
            if (cosine < 0) return what + ": the ray comes towards the camera";
            if (!(glm::length(glm::cross(glm::dvec3(ray.direction), direction)) < 2e-5)) {
                const glm::dvec4 flipped = back * glm::dvec4(2.0 * px.x / size.x - 1, 1 - 2.0 * px.y / size.y, 1, 1);
                const glm::dvec3 other = glm::normalize(glm::dvec3(flipped) / flipped.w - glm::dvec3(camera.position));
                const glm::dvec3 got(ray.direction);
                return fmt::format("{}: as the direction it {}{}", what, gave_text({&got.x, 3}, {&direction.x, 3}),
                                   glm::dot(got, other) > 0.99999 ? ": y = -1 is the top" : "");
            }
            const double off = glm::length(glm::dvec3(ray.origin) - origin);
            if (!(off < 1e-3 * (1 + double(camera.near_m)) + 4e-6 * glm::length(origin)))
                return fmt::format("{}: it begins {:.4g} m from where it should, on the near plane (depth 1)", what,
                                   off);
            return "";
        });
        if (check.failed) return;
    }
}

CHECK_EXERCISE("18.drag_on_axis", "c = cross(axis, d); dot(c, cross(w, d)) over dot(c, c), which is at least 0.0302.") {
    const double least = std::pow(std::sin(glm::radians(10.0)), 2);
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 axis = i % 3 == 0 ? glm::vec3(0, 0, 1) : random.direction();
        const glm::vec3 pivot = i % 5 ? 5.0f * random.direction() : 1000.0f * random.direction();
        const double degrees = i < 20       ? double(i) / 2
                               : i % 4 == 0 ? random.logarithmic(1e-4, 10)
                                            : random.uniform(0, 90);
        const glm::dvec3 a(axis),
            side = glm::normalize(glm::cross(a, std::fabs(a.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const double angle = glm::radians(degrees);
        PickRay ray;
        ray.direction = glm::vec3(glm::normalize(std::cos(angle) * a * (i % 2 ? 1.0 : -1.0) + std::sin(angle) * side));
        ray.origin = pivot + 10.0f * random.direction();
        const glm::dvec3 d(ray.direction), w = glm::dvec3(ray.origin) - glm::dvec3(pivot), c = glm::cross(a, d);
        const double s = glm::dot(c, c), right = glm::dot(c, glm::cross(w, d)) / std::max(s, least);
        const std::string what = fmt::format("drag_on_axis(a ray at {:.4g}° to the axis, {:.3g} m from the origin)",
                                             degrees, glm::length(pivot));
        check.call(what, [&]() -> std::string {
            const float got = drag_on_axis(ray, pivot, axis);
            if (!std::isfinite(got)) return what + " is no number: the lines are parallel, and the divisor is 0";
            if (std::fabs(double(got) - right) <= 2e-4 * (1 + std::fabs(right)) + (i % 5 ? 0 : 4e-3)) return "";
            const double free = glm::dot(c, glm::cross(w, d)) / s;
            const std::string why =
                s < least && std::fabs(double(got) - free) < 1e-2 * std::fabs(free) ? ": below 10° it must slow down"
                : std::fabs(double(got) + right) < 1e-3 * (1 + std::fabs(right))    ? ": the other way around"
                                                                                    : "";
            return what + " " + gave_text(double(got), right) + " (metres)" + why;
        });
        if (check.failed) return;
    }
}

CHECK_EXERCISE("18.rotate_about_pivot",
               "The new rotation on the left, then normalize; the arm from the pivot, in double precision.") {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const glm::dquat before = glm::angleAxis(random.uniform(-3, 3), glm::dvec3(random.direction()));
        const double length = i % 4 ? 1.0 : random.uniform(0.999, 1.001);
        const Pose pose{3.0f * random.direction() + (i % 3 ? glm::vec3(0) : glm::vec3(1000, 0, 0)),
                        glm::quat(before * length)};
        const glm::vec3 pivot = pose.position + random.direction(), axis = random.direction();
        const float angle = i == 0 ? 0.0f : static_cast<float>(random.uniform(-6, 6));
        const glm::dquat turn = glm::angleAxis(double(angle), glm::dvec3(axis)), right = glm::normalize(turn * before);
        const glm::dvec3 place = glm::dvec3(pivot) + turn * (glm::dvec3(pose.position) - glm::dvec3(pivot));
        const std::string what = fmt::format("rotate_about_pivot({:.1f}° about {}, the pivot at {})",
                                             glm::degrees(angle), text(axis), text(pivot));
        check.call(what, [&]() -> std::string {
            const Pose got = rotate_about_pivot(pose, pivot, axis, angle);
            const double size = glm::length(glm::dquat(got.orientation)),
                         off = glm::length(glm::dvec3(got.position) - place);
            if (!(std::fabs(size - 1) < 1e-6))
                return fmt::format("{}: the orientation has the length {:.7g}, expected 1 to 1e-6", what, size);
            const double same = std::fabs(glm::dot(glm::normalize(glm::dquat(got.orientation)), right));
            if (!(same > 1 - 1e-10)) {
                const double other = std::fabs(glm::dot(glm::dquat(got.orientation), glm::normalize(before * turn)));
                return fmt::format("{}: the orientation is {:.3g}° off{}", what,
                                   glm::degrees(2 * std::acos(std::min(same, 1.0))),
                                   other > 1 - 1e-6 ? ": the new rotation stands on the left of the product" : "");
            }
            if (!(off < 2e-6 + 1.2e-7 * glm::length(place)))
                return fmt::format("{}: the position is {:.4g} m off{}", what, off,
                                   glm::length(glm::dvec3(got.position) - turn * glm::dvec3(pose.position)) < 1e-2
                                       ? ": it turned about the origin"
                                       : "");
            return "";
        });
        if (check.failed) return;
    }
    const std::string what = "100,000 turns of 3.6° about a pivot 1 m away";
    check.call(what, [&]() -> std::string {
        Pose pose{{1, 0, 0}, {1, 0, 0, 0}};
        for (int i = 0; i < 100000; ++i) pose = rotate_about_pivot(pose, {0, 0, 0}, {0, 1, 0}, glm::radians(3.6f));
        const double off = glm::length(glm::dvec3(pose.position) - glm::dvec3(1, 0, 0)),
                     size = glm::length(glm::dquat(pose.orientation));
        if (!(std::fabs(size - 1) < 1e-5)) return fmt::format("{}: the orientation has the length {:.5f}", what, size);
        return off < 0.02 ? "" : fmt::format("{}: it is {:.3g} m from where it began", what, off);
    });
}

CHECK_EXERCISE(
    "18.id_buffer",
    "Item 0 must differ from nothing: item + 1. Look at a square, inside the image; keep the first of the nearest.") {
    Probe codes{
        .include = "18_playground/id_buffer.glsl",
        .before = "#include \"../tests/18_playground/known_ids.glsl\"\n",
        .signature = "uint id_of(uint item)",
        .inputs =
            {{0}, {1}, {2047}, {2048}, {16777215}, {16777216}, {16777217}, {1000000006}, {2147483647}, {4294967294}},
        .truth = [](auto in) { return Row{in[0] + 1}; },
        .macros = {{"IDS_WIDTH", "4"}, {"IDS_HEIGHT", "4"}, {"IDS_EVERY", "7"}},
        .hint = [](auto in, auto out) -> std::string {
            if (in[0] == 0 && out[0] == 0) return "0 is what the image is cleared to: item 0 would be nothing";
            return "";
        }};
    check.probe(codes);
    codes.signature = "uint item_of(uint id)";
    codes.inputs = {{1}, {2}, {2049}, {16777217}, {16777218}, {1000000007}, {2147483648}, {4294967295}};
    codes.truth = [](auto in) { return Row{in[0] - 1}; };
    codes.hint = nullptr;
    check.probe(codes);
    for (const auto& [width, height, every] :
         {std::array{9, 7, 11}, {9, 7, 41}, {16, 1, 5}, {1, 1, 7}, {20, 20, 97}, {12, 12, 4}}) {
        const auto id_at = [=](int x, int y) { return (7 * x + 13 * y) % every == 3 ? 16777216 + y * width + x : 0; };
        Probe near{.include = "18_playground/id_buffer.glsl",
                   .before = "#include \"../tests/18_playground/known_ids.glsl\"\n",
                   .signature = "uint id_near(ivec2 pixel, int reach)",
                   .truth =
                       [=](auto in) {
                           double found = 0, nearest = in[2] * in[2] + 1;
                           for (int y = 0; y < height; ++y)
                               for (int x = 0; x < width; ++x) {
                                   const double far = (x - in[0]) * (x - in[0]) + (y - in[1]) * (y - in[1]);
                                   if (far < nearest && id_at(x, y)) {
                                       found = id_at(x, y);
                                       nearest = far;
                                   }
                               }
                           return Row{found};
                       },
                   .macros = {{"IDS_WIDTH", std::to_string(width)},
                              {"IDS_HEIGHT", std::to_string(height)},
                              {"IDS_EVERY", std::to_string(every)}},
                   .hint = [=](auto in, auto out) -> std::string {
                       if (out[0] == 70000000) return "that pixel is outside of the image";
                       if (out[0] == 0) return "there is a number within reach";
                       const int place = int(out[0]) - 16777216, x = place % width, y = place / width;
                       if (out[0] > 0 && id_at(x, y) == int(out[0]) &&
                           (x - in[0]) * (x - in[0]) + (y - in[1]) * (y - in[1]) > in[2] * in[2])
                           return "the corners of the square are farther than `reach`";
                       return "nearer ones first; of equally near ones the upper, then the left";
                   }};
        Random random(4);
        for (const double reach : {0.0, 2.0, 5.0})
            near.inputs.push_back({double(width / 2), double(height / 2), reach});
        for (int y = -2; y < height + 2; ++y)
            for (int x = -2; x < width + 2; ++x)
                near.inputs.push_back({double(x), double(y), std::floor(random.uniform(0, 6))});
        near.inputs.push_back({0, 0, 16});
        near.inputs.push_back({-30, 4, 8});
        for (const double x : {-9.0, width + 9.0}) near.inputs.push_back({x, double(height / 2), 30});
        check.probe(near);
        if (check.failed) return;
    }
}
