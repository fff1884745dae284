// Checks of the exercises about transparent surfaces.
#include <fmt/core.h>

#include <cmath>
#include <map>

#include "15_terrain_water/exercises.h"
#include "15_terrain_water/transparency_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("15.wboit_weight", "Square and cube by multiplying; clamp x before it is multiplied by alpha.") {
    Probe probe{
        .include = "15_terrain_water/wboit_weight.glsl",
        .signature = "float wboit_weight(int equation, float alpha, float distance_m, float depth)",
        .inputs = {},
        .truth = [](std::span<const double> in) { return Row{truth::wboit_weight(int(in[0]), in[1], in[2], in[3])}; },
        .bound = {.absolute = 1e-7, .relative = 1e-3},
        .hint = [](auto in, auto out) -> std::string {
            const int equation = int(in[0]);
            if (equation == 0) return "Equation 0 is a plain mean.";
            // What each mistake would have made of it.
            const auto is = [&](double other) { return std::fabs(out[0] - other) <= 1e-3 * std::fabs(other) + 1e-7; };
            const double w = truth::wboit_weight(equation, in[1], in[2], in[3]);
            const double x = truth::wboit_weight(equation, 1, in[2], in[3]);
            if (in[1] != 1 && is(x)) return "The clamped x is multiplied by alpha.";
            if (in[1] != 1 && is(std::clamp(in[1] * x, 0.01, 3000.0)))
                return "x alone is clamped, and multiplied by alpha after that.";
            if (equation == 4 && is(truth::wboit_weight(4, in[1], in[2], 1 - in[3])))
                return "depth is 0 at the near plane: 1 - d is great where the fragment is near.";
            for (const int other : {1, 2, 3, 4})
                if (other != equation && is(truth::wboit_weight(other, in[1], in[2], in[3])))
                    return fmt::format("That is the weight of `equation` {}.", other);
            if (w == 0.01 * in[1] || w == 3000 * in[1]) return "x stays within 0.01 and 3000.";
            const char* divisors[] = {"", "z / 5 squared, z / 200 to the power of 6",
                                      "z / 10 cubed, z / 200 to the power of 6",
                                      "z / 200 to the power of 4, and 0.03 on top", "(1 - d) cubed, times 3000"};
            return fmt::format("Equation {} has {}.", equation, divisors[equation]);
        }};
    Random random(7);
    for (int equation = 0; equation < 5; ++equation) {
        for (const double z : {1.0, 5.0, 20.0, 200.0, 1000.0, 0.2, 0.05})
            for (const double alpha : {0.5, 1.0, 0.0})
                probe.inputs.push_back({double(equation), alpha, z, 1 - 0.05 / z});
        probe.inputs.push_back({double(equation), 0.5, 1, 1.000001});
        for (int i = 0; i < 40; ++i)
            probe.inputs.push_back(
                {double(equation), random.uniform(0, 1), random.logarithmic(0.1, 500), random.uniform(0, 1)});
    }
    check.probe(probe);
}

CHECK_EXERCISE("15.tint_through", "Multiply three shares: passed, 1 - alpha, and tint.") {
    Probe probe{.include = "15_terrain_water/tint_through.glsl",
                .signature = "vec3 tint_through(vec3 passed, float alpha, vec3 tint)",
                .inputs = {{1, 1, 1, 0, 1, 1, 1},
                           {1, 1, 1, 1, 1, 0.5, 0},
                           {0, 0.5, 1, 0, 0.5, 0.25, 0},
                           {1, 1, 1, 0.25, 1, 1, 1}},
                .truth =
                    [](std::span<const double> in) {
                        Row out;
                        for (size_t i = 0; i < 3; ++i) out.push_back(truth::passed_share({in[i], in[3], in[4 + i]}));
                        return out;
                    },
                .bound = {.absolute = 1e-6, .relative = 0},
                .hint = [](auto in, auto out) -> std::string {
                    // What each mistake would have made of it.
                    const auto is = [&](auto&& other) {
                        for (size_t i = 0; i < 3; ++i)
                            if (std::fabs(out[i] - other(in[i], in[3], in[4 + i])) > 1e-6) return false;
                        return true;
                    };
                    if (is([](double p, double a, double) { return p * (1 - a); }))
                        return "tint filters what alpha leaves.";
                    if (is([](double, double a, double t) { return (1 - a) * t; }))
                        return "The layers in front let through only `passed`.";
                    if (is([](double p, double a, double t) { return p * (1 - a * t); }) ||
                        is([](double p, double a, double t) { return p * (1 - a * (1 - t)); }))
                        return "tint is a share of what passes, not of what alpha covers.";
                    if (is([](double p, double a, double t) { return p * (1 - a) * (1 - t); }))
                        return "tint is the share that passes, not the share that is absorbed.";
                    return "Three shares, multiplied in each channel.";
                }};
    Random random(66);
    for (int i = 0; i < 60; ++i) {
        Row row;
        for (int k = 0; k < 7; ++k) row.push_back(random.uniform(0, 1));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

namespace {

// Absorbance at up to three depths, the first of which is the surface's.
struct Absorbed {
    double depth, share;
};

// Four means over it, of which a share of 1e-5 is that of two peaks and an even rest, where there are fewer than three depths.
Row means_of(const std::vector<Absorbed>& all) {
    const double even[] = {0, 0.375, 0, 0.375};
    Row means;
    for (int k = 1; k <= 4; ++k) {
        double mean = 0;
        for (const Absorbed& a : all) mean += a.share * std::pow(a.depth, k);
        means.push_back(static_cast<float>(all.size() < 3 ? glm::mix(mean, even[k - 1], 1e-5) : mean));
    }
    return means;
}

}  // namespace

CHECK_EXERCISE(
    "15.moment_transmittance",
    "the matrix of the lesson gives the other two depths; then three equations, for the means of 1, z and z², "
    "give what lies at each") {
    std::map<Row, std::vector<Absorbed>> layers;  // by the arguments that they give
    const auto transmittance = [&](std::span<const double> in, double at_itself, bool behind = false) {
        double before = 0;
        for (const Absorbed& a : layers.at(Row(in.begin(), in.end())))
            before += a.share * (a.depth == in[5] ? at_itself : (a.depth < in[5]) != behind ? 1.0 : 0.0);
        return std::exp(-in[4] * before);
    };
    Probe probe{.include = "15_terrain_water/moment_transmittance.glsl",
                .signature = "float moment_transmittance(vec4 b, float all, float z, float overestimation)",
                .inputs = {},
                .truth = [&](auto in) { return Row{transmittance(in, in[6])}; },
                .bound = {.absolute = 2e-3},
                .hint = [&](auto in, auto out) -> std::string {
                    const auto is = [&](double other) { return std::abs(out[0] - other) <= 2e-3; };
                    const size_t depths = layers.at(Row(in.begin(), in.end())).size();
                    const double right = transmittance(in, in[6]);
                    if (is(transmittance(in, 1)) || is(transmittance(in, 0)))
                        return "of what lies at z itself, the fraction `overestimation` is in front of it";
                    if (is(transmittance(in, in[6], true))) return "a smaller depth is nearer";
                    if (is(-std::log(right))) return "that is the absorbance; its transmittance is asked for";
                    if (is(std::pow(right, 1 / in[4]))) return "b holds means: the absorbance is `all` times as much";
                    if (depths < 3)
                        return fmt::format("this pixel has {} layer{}: its equations are almost singular", depths,
                                           depths == 1 ? "" : "s");
                    return "";
                }};
    const auto add = [&](const std::vector<Absorbed>& where, double all, double overestimation) {
        Row row = means_of(where);
        row.insert(row.end(), {all, where[0].depth, overestimation});
        layers[row] = where;
        probe.inputs.push_back(row);
    };
    add({{0, 0.5}, {-0.5, 0.25}, {0.5, 0.25}}, 1, 0.25);
    add({{-0.5, 0.25}, {0, 0.25}, {0.5, 0.5}}, 2, 0);
    add({{0.5, 0.25}, {-0.25, 0.5}, {0, 0.25}}, 2, 1);
    add({{0.25, 1}}, 1, 0.25);
    add({{0.5, 0.5}, {-0.5, 0.5}}, 2, 0.25);
    add({{-0.5, 0.5}, {0.5, 0.5}}, 2, 0.25);
    // Eighths and sixteenths: their means are exact in a float.
    Random random(67);
    const auto whole = [&](int lower, int upper) { return std::floor(random.uniform(lower, upper + 0.999)); };
    while (probe.inputs.size() < 300) {
        const double fill[] = {whole(2, 12), whole(2, 12)};
        if (fill[0] + fill[1] > 14) continue;
        std::vector<Absorbed> where{{whole(-8, 8) / 8, fill[0] / 16},
                                    {whole(-8, 8) / 8, fill[1] / 16},
                                    {whole(-8, 8) / 8, (16 - fill[0] - fill[1]) / 16}};
        const int count = probe.inputs.size() % 10 == 0 ? 1 : probe.inputs.size() % 5 == 0 ? 2 : 3;
        bool apart = true;
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < i; ++j) apart &= std::abs(where[size_t(i)].depth - where[size_t(j)].depth) > 0.24;
        if (!apart) continue;
        if (count < 3)
            where = count == 1
                        ? std::vector<Absorbed>{{where[0].depth, 1}}
                        : std::vector<Absorbed>{{where[0].depth, fill[0] / 16}, {where[1].depth, 1 - fill[0] / 16}};
        add(where, random.uniform(0.1, 4), whole(0, 4) / 4);
    }
    check.probe(probe);
}

CHECK_EXERCISE("15.sort_back_to_front", "std::stable_sort the numbers 0, 1, 2 ... by distance, the greatest first.") {
    Random random(9);
    const auto place = [&] {
        return glm::vec3(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50));
    };
    struct Case {
        std::string name;
        std::vector<glm::vec3> middles;
        glm::vec3 eye{0};
        std::vector<uint32_t> order = {};  // the only right one, where two are equally far
    };
    std::vector<Case> cases{
        {"no surface", {}},
        {"one surface", {{1, 2, 3}}},
        {"surfaces at 1, 3 and 2 m", {{0, 0, -1}, {0, 0, -3}, {0, 0, -2}}},
        {"one 5 m to the side, one 3 m ahead", {{0, 0, -3}, {5, 0, -1}}},
        {"one 9 m behind the eye, one 3 m ahead", {{0, 0, -3}, {0, 0, 9}}},
        {"three equally far", {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {}, {0, 1, 2}},
        {"three equally far, in another order", {{0, 0, 2}, {-2, 0, 0}, {0, 2, 0}}, {}, {0, 1, 2}},
        {"two equally far, one nearer between them", {{3, 4, 0}, {0, 0, 1}, {0, -5, 0}, {0, 0, -9}}, {}, {3, 0, 2, 1}},
        {"an eye away from the origin", {{10, 0, 0}, {11, 0, 0}}, {12, 0, 0}}};
    Case many{"200 surfaces", {}, place()};
    for (int i = 0; i < 200; ++i) many.middles.push_back(place());
    Case equal{"100 surfaces in five places", {}, place()};
    for (int i = 0; i < 100; ++i) equal.middles.push_back(i < 5 ? place() : equal.middles[size_t(i) % 5]);
    Case large{"10,000 surfaces", {}, place()};
    for (int i = 0; i < 10000; ++i) large.middles.push_back(place());
    cases.insert(cases.end(), {many, equal, large});
    for (const Case& one : cases) {
        const std::string what = "sort_back_to_front(" + one.name + ")";
        check.call(what, [&]() -> std::string {
            const std::vector<uint32_t> got = sort_back_to_front(one.middles, one.eye);
            if (got.size() != one.middles.size())
                return fmt::format("{} gave {} numbers, expected {}", what, got.size(), one.middles.size());
            std::vector<bool> seen(got.size());
            for (const uint32_t i : got) {
                if (i >= seen.size() || seen[i])
                    return fmt::format("{} gave the number {} twice or beyond the last", what, i);
                seen[i] = true;
            }
            for (size_t i = 1; i < got.size(); ++i) {
                const float before = glm::length(one.middles[got[i - 1]] - one.eye),
                            after = glm::length(one.middles[got[i]] - one.eye);
                if (before < after * 0.999999f)
                    return fmt::format("{}: number {}, {:.3f} m away, comes before number {}, {:.3f} m away", what,
                                       got[i - 1], before, got[i], after);
                const bool tie = one.order.empty() ? one.middles[got[i - 1]] == one.middles[got[i]] : before == after;
                if (tie && got[i - 1] > got[i])
                    return fmt::format("{}: numbers {} and {} are equally far, and have changed places", what, got[i],
                                       got[i - 1]);
            }
            return "";
        });
        if (check.failed) return;
    }
    check.expect_no_square("sort_back_to_front", 1000, [&](size_t count) {
        sort_back_to_front({large.middles.begin(), large.middles.begin() + long(count)}, large.eye);
    });
}
