// Checks of the exercises about water.
#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <complex>

#include "01_obj/camera_view.h"
#include "15_terrain_water/exercises.h"
#include "15_terrain_water/water_truth.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/check/workgroup.h"

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

namespace {

using Complex = std::complex<double>;
constexpr size_t texels = 256, fields = 2, lines = 4;

// Sums of 256 terms each, added up as they are written.
std::vector<Complex> transform(const std::vector<Complex>& line) {
    std::vector<Complex> turns(texels), sums(texels);
    for (size_t i = 0; i < texels; ++i) turns[i] = std::polar(1.0, 2 * M_PI * double(i) / double(texels));
    for (size_t n = 0; n < texels; ++n)
        for (size_t k = 0; k < texels; ++k) sums[n] += line[k] * turns[k * n % texels];
    return sums;
}

size_t bits_reversed(size_t i) {
    size_t all = 0;
    for (int bit = 0; bit < 8; ++bit) all |= (i >> bit & 1) << (7 - bit);
    return all;
}

// A field of a line of a case: a wave alone, then random ones.
std::vector<Complex> given_line(Random& random, size_t which, size_t line, size_t field) {
    std::vector<Complex> all(texels);
    const size_t alone[] = {0, 1, 128, 255, 3, 64, 130, 77};
    if (which == 0) all[alone[fields * line + field]] = {1, 0.5};
    for (Complex& one : all)
        if (which > 0) one = {random.uniform(-1, 1), random.uniform(-1, 1)};
    return all;
}

}  // namespace

CHECK_EXERCISE(
    "15.fourier_lines",
    "eight steps; in each, a pair's sum and turned difference, a barrier() between all reads and all writes") {
    // Each thread puts in, and reads back, what others work on.
    const std::string before = R"(
#define OCEAN_LINE_GIVEN
shared vec4 line[1024];
vec4 turned(vec4 two, uint by) {
    check_count(stands_for);
    if (by > 127u) return vec4(1e9);
    vec2 turn = vec2(cos(6.2831853 * float(by) / 256.0), sin(6.2831853 * float(by) / 256.0));
    return vec4(two.x * turn.x - two.y * turn.y, two.x * turn.y + two.y * turn.x, two.z * turn.x - two.w * turn.y,
                two.z * turn.y + two.w * turn.x);
}
)";
    const std::string call = R"(
for (uint i = 0u; i < 4u; ++i)
    for (uint c = 0u; c < 4u; ++c)
        line[256u * i + 255u - local][c] = uintBitsToFloat(given[((case_index * 4u + i) * 256u + 255u - local) * 4u + c]);
fourier_lines(local);
for (uint i = 0u; i < 4u; ++i)
    for (uint c = 0u; c < 4u; ++c) put(4u * i + c, floatBitsToUint(line[256u * i + (local ^ 85u)][c]));
)";
    constexpr size_t cases = 3;
    Random random(15);
    std::vector<uint32_t> given(cases * lines * texels * 2 * fields);
    std::vector<std::vector<Complex>> lines_given, lines_right;
    for (size_t which = 0; which < cases; ++which)
        for (size_t line = 0; line < lines; ++line)
            for (size_t field = 0; field < fields; ++field) {
                const auto one = given_line(random, which, line, field);
                for (size_t k = 0; k < texels; ++k) {
                    uint32_t* to = &given[(((which * lines + line) * texels + k) * fields + field) * 2];
                    to[0] = std::bit_cast<uint32_t>(static_cast<float>(one[k].real()));
                    to[1] = std::bit_cast<uint32_t>(static_cast<float>(one[k].imag()));
                }
                lines_given.push_back(one);
                lines_right.push_back(transform(one));
            }
    const WorkgroupResults results(check_device(), {.include = "15_terrain_water/fourier_lines.glsl",
                                                    .before = before,
                                                    .call = call,
                                                    .given = given,
                                                    .cases = cases,
                                                    .puts = 2 * fields * lines,
                                                    .counts = texels});
    for (uint32_t which = 0; which < cases; ++which)
        for (uint32_t order = 0; order < workgroup_orders; ++order) {
            for (uint32_t line = 0; line < lines; ++line)
                for (uint32_t field = 0; field < fields; ++field) {
                    const size_t at = (which * lines + line) * fields + field;
                    const std::vector<Complex>& right = lines_right[at];
                    const auto got = [&](size_t n) {
                        const auto local = static_cast<uint32_t>(n) ^ 85u;
                        const uint32_t first = 4 * line + 2 * field;
                        return Complex(double(std::bit_cast<float>(results.at(which, order, local, first))),
                                       double(std::bit_cast<float>(results.at(which, order, local, first + 1))));
                    };
                    const auto is = [&](const std::function<Complex(size_t)>& other) {
                        for (size_t n = 0; n < texels; ++n)
                            if (!(std::abs(got(n) - other(n)) < 1e-3)) return false;
                        return true;
                    };
                    size_t wrong = texels;
                    for (size_t n = texels; n-- > 0;)
                        if (!(std::abs(got(n) - right[n]) < 1e-3)) wrong = n;
                    if (wrong == texels) continue;
                    std::string hint;
                    if (is([&](size_t n) { return right[(texels - n) % texels]; }))
                        hint = "that is the sum with e^(-2 pi i k n / 256): the turn goes the other way";
                    if (is([&](size_t n) { return right[bits_reversed(n)]; }))
                        hint = "all sums are there, in the order of their numbers' bits reversed";
                    if (is([&](size_t n) { return right[n] / double(texels); })) hint = "a sum, and no mean";
                    if (order > 0)
                        hint =
                            "with the threads in another order: is there a barrier() between what one thread writes to "
                            "shared memory and what another reads, and between reads and the next writes?";
                    const Complex g = got(wrong), r = right[wrong];
                    check.expect(
                        false,
                        fmt::format("fourier_lines with {}: texel {} of line {} has the {} number ({:.6g}, {:.6g}), "
                                    "expected ({:.6g}, {:.6g})",
                                    which == 0 ? "a wave in each line" : "random waves", wrong, line,
                                    field == 0 ? "first" : "second", g.real(), g.imag(), r.real(), r.imag()),
                        hint);
                    return;
                }
            for (uint32_t thread = 0; thread < texels; ++thread) {
                const uint32_t turns = results.count(which, order, thread);
                if (turns <= 16) continue;
                check.expect(false,
                             fmt::format("fourier_lines: thread {} called turned() {} times, expected at most 16",
                                         thread, turns),
                             "256 threads share the 512 butterflies of a step; each turns one difference");
                return;
            }
            check.expect(true, "");
        }
    const std::string wrong = results.barriers();
    check.expect(wrong.empty(), "fourier_lines: " + wrong, barrier_hint);
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
