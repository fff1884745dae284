// Checks of the exercises that sum: 14.sh_project, and 14.split_sum_table with a whole workgroup.
#include <fmt/core.h>

#include <bit>

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
