// Checks of the exercises that sum: 14.sh_project, 14.environment_brdf, and 14.split_sum_table with a whole workgroup.
#include <fmt/core.h>

#include <bit>
#include <map>

#include "14_environment/exercises.h"
#include "14_environment/truth.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/check/workgroup.h"

using namespace lightwalk;

namespace {

std::vector<glm::vec3> picture_of(int width, int height, const std::function<glm::dvec3(glm::dvec3)>& light) {
    std::vector<glm::vec3> texels;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            texels.emplace_back(light(truth::direction_at({(column + 0.5) / width, (row + 0.5) / height})));
    return texels;
}

Sh9 right_sums(int width, int height, const std::vector<glm::vec3>& texels) {
    Sh9 sums(9);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto basis = truth::harmonics(truth::direction_at({(column + 0.5) / width, (row + 0.5) / height}));
            const glm::dvec3 light = truth::equirect_solid_angle(row, width, height) *
                                     glm::dvec3(texels[size_t(row) * size_t(width) + size_t(column)]);
            for (size_t i = 0; i < 9; ++i) sums[i] += basis[i] * light;
        }
    return sums;
}

}  // namespace

CHECK_EXERCISE("14.sh_project",
               "each texel: its colour times its solid angle, width (cos(top) - cos(bottom)), times each of nine Y") {
    Random random;
    const glm::dvec3 side(random.direction());
    struct Case {
        std::string name;
        int width, height;
        std::function<glm::dvec3(glm::dvec3)> light;
    };
    const std::vector<Case> cases{
        {"white everywhere", 32, 16, [](glm::dvec3) { return glm::dvec3(1); }},
        {"x, y and z of each direction as red, green and blue", 32, 16, [](glm::dvec3 d) { return d; }},
        {"red along +y alone", 64, 32, [](glm::dvec3 d) { return glm::dvec3(d.y > 0.9, 0, 0); }},
        {"products of x, y and z", 64, 32, [](glm::dvec3 d) { return glm::dvec3(d.x * d.y, d.y * d.z, d.x * d.z); }},
        {"squares of x, y and z", 33, 17, [](glm::dvec3 d) { return d * d; }},
        {"a light to one side", 64, 32,
         [side](glm::dvec3 d) { return glm::dvec3(5, 3, 2) * std::pow(std::max(glm::dot(d, side), 0.0), 8); }},
        {"one texel high", 2, 1, [](glm::dvec3 d) { return glm::dvec3(d.x > 0, 1, 2); }},
        {"black", 8, 4, [](glm::dvec3) { return glm::dvec3(0); }}};
    for (const Case& one : cases) {
        const auto texels = picture_of(one.width, one.height, one.light);
        const Sh9 right = right_sums(one.width, one.height, texels);
        const std::string what = fmt::format("sh_project({}x{}, {})", one.width, one.height, one.name);
        check.call(what, [&]() -> std::string {
            const Sh9 got = sh_project(one.width, one.height, texels);
            if (got.size() != 9) return fmt::format("{} gave {} coefficients, expected 9", what, got.size());
            for (size_t i = 0; i < 9; ++i) {
                const double away = glm::length(got[i] - right[i]);
                if (!(away < 1e-5 + 1e-5 * glm::length(right[i])))
                    return fmt::format("{}: as coefficient {} it {}", what, i,
                                       gave_text({&got[i].x, 3}, {&right[i].x, 3}));
            }
            return "";
        });
    }
}

CHECK_EXERCISE(
    "14.environment_brdf",
    "the integrand over the density of l; D, v·h and n·v cancel if you draw the half vectors that are visible") {
    constexpr int samples = 1024;
    // Grazing views last: there the choice of half vectors matters most.
    const double cosines[] = {0.7, 1, 0.3, 0.05, 0.001}, alphas[] = {0.3, 1, 0.05, 0.001};
    Probe probe{.include = "14_environment/environment_brdf.glsl",
                .signature = "vec2 environment_brdf(vec2 random, float n_dot_v, float alpha)"};
    std::vector<glm::dvec2> cases;
    Random random;
    for (const double n_dot_v : cosines)
        for (const double alpha : alphas) {
            if (n_dot_v < 0.05 && alpha < 0.05) continue;  // beyond the reference's steps
            cases.emplace_back(static_cast<float>(n_dot_v), static_cast<float>(alpha));
            const double shift = random.uniform(0, 1);
            for (int i = 0; i < samples; ++i) {
                double mirrored = shift;  // the digits of i behind the point
                for (int digit = 0; digit < 10; ++digit) mirrored += (i >> digit & 1) * std::exp2(-digit - 1);
                probe.inputs.push_back({static_cast<float>((i + 0.5) / samples),
                                        std::min(static_cast<float>(mirrored - std::floor(mirrored)), 0.9999999f),
                                        cases.back().x, cases.back().y});
            }
        }
    const Table got = run_probe(check_device(), probe, 2);
    for (size_t which = 0; which < cases.size(); ++which) {
        const double n_dot_v = cases[which].x, alpha = cases[which].y;
        glm::dvec2 mean(0);
        for (size_t i = which * samples; i < (which + 1) * samples; ++i) {
            if (!std::isfinite(got[i][0]) || !std::isfinite(got[i][1])) {
                check.expect(false, call_text(probe, probe.inputs[i]) + " gave " + result_text(probe, got[i]),
                             "light below the surface counts as 0");
                return;
            }
            mean += glm::dvec2(got[i][0], got[i][1]) / double(samples);
        }
        const double b = truth::white_reflection(n_dot_v, alpha, 0);
        const glm::dvec2 right(truth::white_reflection(n_dot_v, alpha, 1) - b, b);
        const auto is = [&](glm::dvec2 v) {
            return glm::all(glm::lessThanEqual(glm::abs(mean - v), glm::dvec2(0.004)));
        };
        std::string hint;
        if (is({right.y, right.x})) hint = "A has the factor 1 - p, B has p";
        if (is({right.x + right.y, right.y})) hint = "A has the factor 1 - p";
        if (glm::distance(4.0 * n_dot_v * mean, right) < 0.15)
            hint = "the solid angle of l is 4 (v·h) times as large as that of h, so its density is smaller";
        if (n_dot_v < 0.5 && glm::distance(mean, right) < 0.05)
            hint = "almost right: at grazing angles, what do half vectors that the camera does not see add but noise?";
        check.expect(is(right),
                     fmt::format("environment_brdf at n·v = {:.3g} and alpha = {:.3g}: the mean of {} samples is "
                                 "({:.4f}, {:.4f}), expected ({:.4f}, {:.4f})",
                                 n_dot_v, alpha, samples, mean.x, mean.y, right.x, right.y),
                     hint);
        if (!is(right)) return;
    }
    // Undefined operations are found by the probe itself.
    std::map<Row, Row> results;
    for (size_t i = 0; i < got.size(); ++i) results[probe.inputs[i]] = got[i];
    probe.truth = [&](auto in) { return results.at(Row(in.begin(), in.end())); };
    probe.bound = {.absolute = 1e-4, .relative = 1e-4};
    check.probe(probe);
}

CHECK_EXERCISE(
    "14.split_sum_table",
    "thread t sums samples t, t + 256, ...; then halves of the shared sums, a barrier() before each reading") {
    // Samples that are integers, so that sums are exact in any order.
    const std::string before = R"(
#define SPLIT_SUM_GIVEN
const uint split_sum_threads = 256u;
uint samples_of_case() { return given[case_index]; }
vec2 split_sum_sample(uint i, uint samples, float n_dot_v, float alpha) {
    check_count(min(i, 1299u));
    bool same = samples == samples_of_case() && n_dot_v == 0.25 && alpha == 0.5;
    return same && i < samples ? vec2(float(i % 7u + given[8] % 5u), float(i * i % 11u)) : vec2(-1e6);
}
)";
    const std::string call = R"(
vec2 sum = split_sum_table(0.25, 0.5, samples_of_case(), local);
put(0u, floatBitsToUint(sum.x));
put(1u, floatBitsToUint(sum.y));
)";
    const std::vector<uint32_t> counts{1, 2, 255, 256, 257, 300, 1024, 1000};
    std::vector<uint32_t> given = counts;
    given.push_back(check_seed());
    const WorkgroupResults results(check_device(), {.include = "14_environment/split_sum_table.glsl",
                                                    .before = before,
                                                    .call = call,
                                                    .given = given,
                                                    .cases = uint32_t(counts.size()),
                                                    .puts = 2,
                                                    .counts = 1300});
    for (uint32_t which = 0; which < counts.size(); ++which) {
        const uint32_t samples = counts[which];
        double x = 0, y = 0;
        for (uint32_t i = 0; i < samples; ++i) {
            x += i % 7 + check_seed() % 5;
            y += i * i % 11;
        }
        x /= samples;
        y /= samples;
        for (uint32_t order = 0; order < workgroup_orders; ++order) {
            for (uint32_t i = 0; i < 1300; ++i) {
                const uint32_t times = results.count(which, order, i), wanted = i < samples ? 1 : 0;
                if (times == wanted) continue;
                check.expect(
                    false,
                    fmt::format("split_sum_table with {} samples: sample {} was computed {} times, expected {}",
                                samples, i, times, wanted),
                    "a loop from thread to below samples, in steps of split_sum_threads");
                return;
            }
            const double got_x = std::bit_cast<float>(results.at(which, order, 0, 0));
            const double got_y = std::bit_cast<float>(results.at(which, order, 0, 1));
            const bool right = std::fabs(got_x - x) < 1e-4 * (1 + x) && std::fabs(got_y - y) < 1e-4 * (1 + y);
            check.expect(
                right,
                fmt::format("split_sum_table with {} samples: thread 0 returned ({:.6g}, {:.6g}), expected the "
                            "mean ({:.6g}, {:.6g})",
                            samples, got_x, got_y, x, y),
                order > 0 ? "with the threads in another order: is there a barrier() between what one thread "
                            "writes to shared memory and what another reads?"
                          : "");
            if (!right) return;
        }
    }
    const std::string wrong = results.barriers();
    check.expect(wrong.empty(), "split_sum_table: " + wrong, barrier_hint);
}
