// Checks of the exercises about water.
#include <fmt/core.h>

#include <cmath>

#include "01_obj/camera_view.h"
#include "15_terrain_water/exercises.h"
#include "15_terrain_water/water_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

glm::dvec2 two(std::span<const double> in) { return {in[0], in[1]}; }

// at, k, amplitude, steepness, phase.
Table waves() {
    Table all{{0, 0, 1, 0, 0.1, 0.5, 0},   {1, 0, 1, 0, 0.1, 0.5, 0},  {0, 1, 1, 0, 0.1, 0.5, 0},
              {3, 2, 0, 2, 0.2, 0, 1},     {3, 2, -2, 0, 0.2, 0.7, 1}, {1, 1, 0.01, -0.01, 3, 0.9, 2},
              {5, -4, 3, 4, 0.05, 1, 0.5}, {5, -4, 3, 4, 0.05, 3, 0.5}};
    Random random(15);
    for (int i = 0; i < 200; ++i)
        all.push_back({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3), random.uniform(-3, 3),
                       random.uniform(0, 0.3), random.uniform(0, 2), random.uniform(0, 6.28)});
    return all;
}

}  // namespace

CHECK_EXERCISE("15.gerstner", "The water moves along k / |k|, by a cosine, and rises by a sine of the same phase.") {
    Probe probe{.include = "15_terrain_water/gerstner.glsl",
                .signature = "vec3 gerstner(vec2 at, vec2 k, float amplitude, float steepness, float phase)",
                .inputs = waves(),
                .truth =
                    [](std::span<const double> in) {
                        Row row;
                        append(row, truth::gerstner(two(in), two(in.subspan(2)), in[4], in[5], in[6]));
                        return row;
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-4},
                .hint = [](auto in, auto got) -> std::string {
                    if (in[5] == 0 && (got[0] != 0 || got[2] != 0)) return "Without steepness it only rises and falls.";
                    if (std::hypot(in[2], in[3]) > 1.5 || std::hypot(in[2], in[3]) < 0.5)
                        return "k is no unit vector: the direction of the wave is k / |k|.";
                    return "";
                }};
    check.probe(probe);
}

CHECK_EXERCISE("15.gerstner_normal",
               "Derive gerstner() by x and by z; sum over the waves; the normal is dP/dz cross dP/dx.") {
    Probe slopes{.include = "15_terrain_water/gerstner_normal.glsl",
                 .signature = "mat3 gerstner_slopes(vec2 at, vec2 k, float amplitude, float steepness, float phase)",
                 .inputs = waves(),
                 .truth =
                     [](std::span<const double> in) {
                         Row row;
                         const glm::dmat3 m = truth::gerstner_slopes(two(in), two(in.subspan(2)), in[4], in[5], in[6]);
                         for (int column = 0; column < 3; ++column) append(row, m[column]);
                         return row;
                     },
                 .bound = {.absolute = 1e-5, .relative = 1e-4}};
    check.probe(slopes);
    if (check.failed) return;

    Probe normal{.include = "15_terrain_water/gerstner_normal.glsl",
                 .signature = "vec3 gerstner_normal(mat3 slopes)",
                 .inputs = {Row(9),
                            {0, 0.5, 0, 0, 0, 0, 0, 0, 0},
                            {-1, 0, 0, 0, 0, 0, 0, 0, 0},
                            // Nearly a cusp, of powers of two: it has a direction, and no digit is lost.
                            {std::exp2(-20) - 1, std::exp2(-21), 0, 0, 0, 0, 0, 0, 0},
                            {-1.5, 0.2, 0, 0, 0, 0, 0, 0.1, 0.3}},  // it folds, and the normal points down
                 .truth =
                     [](std::span<const double> in) {
                         glm::dmat3 m;
                         for (int i = 0; i < 9; ++i) m[i / 3][i % 3] = in[size_t(i)];
                         Row row;
                         append(row, truth::normal_of(m));
                         return row;
                     },
                 .bound = {.absolute = 1e-4},
                 .hint = [](auto in, auto got) -> std::string {
                     if (std::isnan(got[0])) return "At a cusp the cross product has no length, and no direction.";
                     if (in[0] != 0 || in[8] != 0)
                         return "The tangents have parts along x and z of their own where the surface is stretched.";
                     return "";
                 }};
    // Sums of four waves, flat and so steep that the surface folds.
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        glm::dmat3 sum(0.0);
        for (int wave = 0; wave < 4; ++wave) {
            const glm::dvec2 k(random.uniform(-3, 3), random.uniform(-3, 3));
            const double share = random.uniform(0.05, i % 2 ? 1.2 : 0.45), amplitude = 0.1 / glm::length(k);
            sum += truth::gerstner_slopes({random.uniform(-9, 9), random.uniform(-9, 9)}, k, amplitude,
                                          share / (amplitude * glm::length(k)), 0);
        }
        Row row;
        for (int column = 0; column < 3; ++column) append(row, sum[column]);
        if (glm::length(glm::cross(glm::dvec3(0, 0, 1) + sum[2], glm::dvec3(1, 0, 0) + sum[0])) > 0.02)
            normal.inputs.push_back(row);
    }
    check.probe(normal);
}

CHECK_EXERCISE("15.fresnel_water", "From below, Snell's law gives the cosine in the air, or total reflection.") {
    const auto onset_of = [](double eye, double other) {  // cosine of total reflection; -1 if there is none
        return other < eye ? std::sqrt(1 - other / eye * (other / eye)) : -1.0;
    };
    Probe probe{.include = "15_terrain_water/fresnel_water.glsl",
                .signature = "float fresnel_water(float cosine, float eye_index, float other_index)",
                .inputs = {{1, 1, 1.333},
                           {1, 1.333, 1},
                           {0, 1, 1.333},
                           {0, 1.333, 1},
                           {1.00001, 1, 1.333},
                           {-0.00001, 1, 1.333},
                           {-0.00001, 1.333, 1},
                           {1.00001, 1.333, 1},
                           {0.5, 1, 1},
                           {1, 1, 1.5}},
                .truth = [](std::span<const double> in) { return Row{truth::fresnel_water(in[0], in[1], in[2])}; },
                .bound = {.absolute = 1e-4},
                .grants =
                    [onset_of](auto in, auto out) {
                        const double onset = onset_of(in[1], in[2]);
                        return std::fabs(in[0] - onset) <= 0.02 &&
                               out[0] <= truth::fresnel_water(in[0] - 1e-4, in[1], in[2]) + 1e-4 &&
                               out[0] >= truth::fresnel_water(in[0] + 1e-4, in[1], in[2]) - 1e-4;
                    },
                .hint = [](auto in, auto got) -> std::string {
                    if (!(got[0] >= 0 && got[0] <= 1)) return "A share of light lies between 0 and 1.";
                    if (in[1] > in[2] && in[0] < 0.66 && got[0] < 1)
                        return "Beyond 48.6 degrees nothing gets from the water into the air.";
                    return "";
                }};
    // Water and air first; the others have a ratio, or the same ratio and other indices, of their own.
    for (const glm::vec2 pair : {glm::vec2(1, 1.333), glm::vec2(1.333, 1), glm::vec2(1.4, 1.05), glm::vec2(1.333, 1.5),
                                 glm::vec2(1.5, 1.333), glm::vec2(2.4, 1), glm::vec2(1, 2.4)})
        for (int i = 0; i <= 100; ++i) {
            probe.inputs.push_back({i / 100.0, pair.x, pair.y});
            const double near = onset_of(double(pair.x), double(pair.y)) + (i - 50) * 4e-4;
            if (near > 0) probe.inputs.push_back({near, pair.x, pair.y});
        }
    const Table results = check.probe(probe);
    check.property(probe, results, "expected a share of the light: not below 0, and not above 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1 + 1e-6; });
}

CHECK_EXERCISE("15.mirror_view",
               "Mirror first, then the camera's matrix, then turn x around; replace the third row last.") {
    struct Case {
        Camera camera;
        float water_m;
        float aspect = 1.6f;
    };
    std::vector<Case> cases;
    for (const float far : {1000.0f, std::numeric_limits<float>::infinity()})
        for (const float water : {0.0f, 2.0f, -7.5f}) {
            cases.push_back({{.position = {3, 9, 12}, .target = {0, 4, 0}, .near_m = 0.1f, .far_m = far}, water});
            cases.push_back(
                {{.position = {-40, 4, 8}, .target = {60, 5, 3}, .near_m = 0.5f, .far_m = far}, water, 0.7f});
            cases.push_back(
                {{.position = {0, 6, 0}, .target = {3, 1, -9}, .up = {0.3f, 1, 0}, .fov_y_rad = 0.4f, .far_m = far},
                 water});
        }
    Random random(2);
    for (const Case& one : cases) {
        const glm::mat4 forward = view_projection(one.camera, one.aspect);
        const std::string what = fmt::format("mirror_view() of a camera {:.1f} m above the water at {:.1f} m",
                                             one.camera.position.y - one.water_m, one.water_m);
        check.call(what, [&]() -> std::string {
            const glm::dmat4 got(mirror_view(forward, one.water_m)), right(forward);
            const glm::dmat4 back = glm::inverse(right);
            for (int i = 0; i < 200; ++i) {
                // The mirrored view of the camera: a ray into the water, and up again.
                const glm::dvec4 near = back * glm::dvec4(random.uniform(-1, 1), random.uniform(-1, 1), 1, 1);
                const glm::dvec3 from(near / near.w), eye(one.camera.position);
                const double t = random.logarithmic(1, 300);
                const glm::dvec3 seen = eye + t * glm::normalize(from - eye);
                const double above = double(one.water_m) - seen.y;
                const glm::dvec4 place(seen.x, double(one.water_m) + above, seen.z, 1);
                const glm::dvec4 expected = right * glm::dvec4(seen, 1), clip = got * place;
                const double size = 1e-4 * (1 + std::fabs(expected.w));
                const std::string where = fmt::format("the place ({:.2f}, {:.2f}, {:.2f})", place.x, place.y, place.z);
                if (!(std::fabs(clip.w - expected.w) <= size))
                    return fmt::format("{}: {} has w = {:.4f}, its mirror image {:.4f}", what, where, clip.w,
                                       expected.w);
                if (!(std::fabs(clip.y - expected.y) <= size))
                    return fmt::format("{}: {} comes out at y = {:.4f}, its mirror image at {:.4f}", what, where,
                                       clip.y, expected.y);
                if (!(std::fabs(clip.x + expected.x) <= size))
                    return fmt::format("{}: {} comes out at x = {:.4f}, expected {:.4f}, turned from left to right",
                                       what, where, clip.x, -expected.x);
                const double margin = 1e-4 * (1 + t);
                if (above > margin && !(clip.w - clip.z > 0))
                    return fmt::format("{}: {} is {:.2f} m above the water, and w - z is {:.5f}: it is clipped", what,
                                       where, above, clip.w - clip.z);
                if (above < -margin && !(clip.w - clip.z < 0))
                    return fmt::format("{}: {} is {:.2f} m below the water, and w - z is {:.5f}: it is not clipped",
                                       what, where, -above, clip.w - clip.z);
                if (above > margin && t < double(one.camera.far_m) * 0.5 && !(clip.z >= -1e-5 * clip.w))
                    return fmt::format("{}: {} is seen mirrored, and z is {:.5f}: it is clipped at the far plane", what,
                                       where, clip.z);
            }
            // Half of the largest scale at least: depth that is spent on nothing.
            const glm::dmat4 mine = glm::transpose(got);
            double highest = 0;
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0}) {
                    glm::dvec4 corner = back * glm::dvec4(x, y, 0, 1);
                    corner.y = 2 * double(one.water_m) * corner.w - corner.y;
                    highest = std::max(highest, corner.y - double(one.water_m) * corner.w);
                }
            const double scale = mine[3].y - mine[2].y;
            if (highest > 0 && scale < 0.49 / highest)
                return fmt::format("{}: the plane is scaled by {:.6f}, and {:.6f} would do", what, scale, 1 / highest);
            return "";
        });
        if (check.failed) return;
    }
}
