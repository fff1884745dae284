// Checks of chapter 16's rays: their parts within a ball and a box, and those that bake, against double precision.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "16_volume/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("16.ray_shell",
               "the place on the ray that is nearest to the centre; from there half a chord to either side") {
    Probe probe{.include = "16_volume/ray_shell.glsl",
                .signature = "vec2 ray_shell(vec3 origin, vec3 direction, float radius)",
                .truth =
                    [](auto in) {
                        const glm::dvec2 range = truth::ray_shell(vector3(in), vector3(in, 3), in[6]);
                        return Row{range.x, range.y};
                    },
                .bound = {.absolute = 1e-3},
                .grants =
                    [](auto in, auto out) {
                        const bool misses = truth::ray_shell(vector3(in), vector3(in, 3), in[6]).y == 0;
                        return misses && std::isfinite(out[0]) && std::isfinite(out[1]) && out[1] <= out[0];
                    },
                .hint = [](auto in, auto out) -> std::string {
                    const glm::dvec2 right = truth::ray_shell(vector3(in), vector3(in, 3), in[6]);
                    const double away = glm::length(vector3(in));
                    if (away < in[6] && out[0] < 0) return "the eye is inside the ball: the ray enters it at 0";
                    if (right.y == 0 && out[1] < 0) return "the ball lies behind the eye: nothing of the ray is in it";
                    if (right.y == 0 && out[1] > out[0]) return "the ray misses the ball: exit <= entry";
                    if (away > 100 * in[6])
                        return "far away b² - c loses the ball: take the ray's distance from the centre";
                    return "";
                }};
    const auto add = [&](glm::dvec3 origin, glm::dvec3 direction, double radius) {
        Row row;
        append(row, glm::vec3(origin));
        append(row, glm::vec3(glm::normalize(direction)));
        row.push_back(radius);
        // At the rim the chord is the root of a small number: there either answer is right.
        const glm::dvec3 from = vector3(row), along = vector3(row, 3);
        const double beside = glm::length(from - glm::dot(from, along) * along) / radius;
        if (std::abs(beside - 1) > 1e-3 * std::max(1.0, glm::length(from) / radius / 100)) probe.inputs.push_back(row);
    };
    add({0, 0, 3}, {0, 0, -1}, 1);
    add({0, 0, 3}, {0, 0, 1}, 1);
    add({0, 0, 0}, {0, 1, 0}, 1);
    add({0, 0.5, 0.5}, {1, 0, 0}, 1);
    add({0, 0, 3}, {0, 1, 0}, 1);
    add({0, 0, 1000}, {0, 0, -1}, 1);
    add({0, 0.9, 1000}, {0, 0, -1}, 1);
    add({600, 0, 800}, {-0.6, 0, -0.8}, 1);
    add({0, 0, 0.99}, {0, 0, 1}, 1);
    Random random(16);
    for (int i = 0; i < 300; ++i) {
        const double radius = random.logarithmic(0.1, 10), away = random.logarithmic(0.05, i % 3 ? 10 : 1000) * radius;
        const glm::dvec3 origin = away * glm::dvec3(random.direction());
        const glm::dvec3 to = random.uniform(0, 1.6) * radius * glm::dvec3(random.direction());
        add(origin, (i % 7 == 0 ? -1.0 : 1.0) * (to - origin), radius);
    }
    const Table results = check.probe(probe);
    // A ray that just touches it, up to rounding: only finite numbers are required.
    Probe tangent = probe;
    tangent.inputs.clear();
    for (int i = -20; i <= 20; ++i) tangent.inputs.push_back({1 + i * 6e-8, 0, 3, 0, 0, -1, 1});
    check.property(tangent, run_probe(check_device(), tangent, 2),
                   "expected numbers: exit <= entry, or both from 0 to 3.01", [](auto, auto out) {
                       const bool misses = std::isfinite(out[0]) && std::isfinite(out[1]) && out[1] <= out[0];
                       return misses || (out[0] >= 0 && out[0] <= 3.01 && out[1] >= 0 && out[1] <= 3.01);
                   });
}

CHECK_EXERCISE("16.ray_box",
               "Of the two planes of an axis the ray meets one first; which one, the direction's sign decides.") {
    const auto cut = [](std::span<const double> in) {
        double from = 0, to = 1e30;
        for (size_t axis = 0; axis < 3; ++axis) {
            const double at = in[axis], along = in[3 + axis], half = in[6 + axis];
            if (std::abs(along) < 1e-12) {
                if (std::abs(at) > half) to = -1;
                continue;
            }
            const double first = ((along > 0 ? -half : half) - at) / along,
                         last = ((along > 0 ? half : -half) - at) / along;
            from = std::max(from, first);
            to = std::min(to, last);
        }
        return glm::dvec2(from, to);
    };
    Probe probe{.include = "16_volume/ray_box.glsl",
                .signature = "vec2 ray_box(vec3 origin, vec3 direction, vec3 half_m)",
                .inputs = {{0, 0, -4, 0, 0, 1, 1, 1, 1},
                           {0, 0, 4, 0, 0, -1, 1, 1, 1},
                           {0, 0, 0, 0, 1, 0, 1, 2, 3},
                           {0.5, 0, 0, -1, 0, 0, 1, 2, 3},
                           {0, 0, -4, 0, 0, -1, 1, 1, 1},
                           {0, 3, -4, 0, 0, 1, 1, 1, 1},
                           {-3, -4, 0, 0.6, 0.8, 0, 1, 1, 1},
                           {3, 4, 0, -0.6, -0.8, 0, 1, 1, 1},
                           // Nearly parallel to a thin slab: into it after 20 m, out of it after 10 m.
                           {0, 0.052, -25, 0, -1e-4, 1, 1, 0.05, 30},
                           {0, 0.049, -20, 0, 1e-4, 1, 1, 0.05, 30},
                           {-20, 0, 4.9e-3, 1, 0, 1e-5, 30, 1, 5e-3}},
                .truth =
                    [cut](auto in) {
                        const glm::dvec2 range = cut(in);
                        return range.y > range.x ? Row{range.x, range.y} : Row{0, 0};
                    },
                .bound = {.absolute = 1e-4, .relative = 1e-5},
                .grants =
                    [cut](auto in, auto out) {
                        const glm::dvec2 range = cut(in);
                        return range.y <= range.x && std::isfinite(out[0]) && std::isfinite(out[1]) && out[1] <= out[0];
                    },
                .hint = [cut](auto in, auto out) -> std::string {
                    const glm::dvec2 range = cut(in);
                    if (out[0] < 0) return "the start is inside the box: the ray enters it at 0";
                    if (range.y <= range.x) return "the ray misses the box: exit <= entry";
                    for (int axis = 3; axis < 6; ++axis)
                        if (in[axis] != 0 && std::abs(in[axis]) < 1e-3)
                            return "a direction is parallel to an axis's planes only where its component is 0";
                    if (std::min({in[3], in[4], in[5]}) < 0)
                        return "which of the two planes of an axis does this ray meet first?";
                    return "";
                }};
    Random random(17);
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 half(random.logarithmic(0.1, 3), random.logarithmic(0.1, 3), random.logarithmic(0.1, 3));
        const glm::dvec3 origin = random.logarithmic(0.05, 10) * glm::dvec3(random.direction());
        const glm::dvec3 to = random.uniform(0, 1.5) * half * glm::dvec3(random.direction());
        Row row;
        append(row, glm::vec3(origin));
        append(row, glm::vec3(glm::normalize(i % 7 ? to - origin : origin - to)));
        append(row, glm::vec3(half));
        // Along an edge or past a corner rounding decides.
        const glm::dvec2 range = cut(row);
        if (std::abs(range.y - range.x) > 1e-3) probe.inputs.push_back(row);
    }
    check.probe(probe);
}

CHECK_EXERCISE("16.bake_ray",
               "points of the square to points of the disc, evenly; then up to the hemisphere above it") {
    Probe probe{.include = "16_volume/bake_ray.glsl",
                .signature = "vec4 bake_ray(vec2 even)",
                .truth =
                    [](auto in) {
                        const double r = std::sqrt(in[0]), phi = 2 * glm::pi<double>() * in[1];
                        return Row{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - in[0]), 1};
                    },
                .bound = {.absolute = 1e-5},
                .grants =
                    [](auto, auto out) {
                        return std::abs(glm::length(vector3(out)) - 1) < 1e-5 && out[2] >= 0 &&
                               std::abs(out[3] - 1) < 1e-6;
                    },
                .hint = [](auto, auto out) -> std::string {
                    const double length = glm::length(vector3(out));
                    if (std::abs(length - 1) > 1e-5) return fmt::format("its length is {:.4g}", length);
                    if (out[2] < 0) return "it leads into the surface";
                    return "if this ray is the only one and meets nothing, the mean is its w";
                }};
    Random random(16);
    const int side = 64;
    const double right = random.uniform(0, 1), up = random.uniform(0, 1);
    for (int i = 0; i < side * side; ++i) probe.inputs.push_back({(i % side + right) / side, (i / side + up) / side});
    const Table rays = check.probe(probe);
    const auto share = [&](const std::string& what, double expected, auto&& is_open) {
        double sum = 0;
        for (const Row& ray : rays)
            if (is_open(vector3(ray))) sum += ray[3];
        sum /= double(rays.size());
        check.expect(std::abs(sum - expected) < 0.012,
                     fmt::format("bake_ray: {} let {:.3f} of the light through, and not {:.3f}", what, sum, expected));
    };
    for (const int degrees : {20, 45, 70}) {  // within it the integral of cos θ / π is sin²
        const double sine = std::sin(glm::radians(double(degrees)));
        share(fmt::format("the directions within {}° of the normal", degrees), sine * sine,
              [=](glm::dvec3 d) { return 1 - d.z * d.z < sine * sine; });
    }
    share("the half of the directions with x > 0", 0.5, [](glm::dvec3 d) { return d.x > 0; });
    share("the quarter with x > 0 and y < 0", 0.25, [](glm::dvec3 d) { return d.x > 0 && d.y < 0; });
    // The form factor of a strip is half the difference of the sines.
    share("a long groove, twice as wide as it is deep,", std::sqrt(0.5),
          [](glm::dvec3 d) { return std::abs(d.x) < d.z; });
    for (const double away : {0.25, 1.0})  // in diameters, from the end of a tube along x: the lesson's closed form
        share(fmt::format("an open end of a tube, {} diameters away,", away),
              (away * away + 0.5) / std::sqrt(away * away + 1) - away, [=](glm::dvec3 d) {
                  const double steps = away / d.x;
                  return d.x > 0 && std::hypot(steps * d.y, steps * d.z - 0.5) < 0.5;
              });
}
