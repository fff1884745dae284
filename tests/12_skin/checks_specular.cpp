// Checks of the exercises about skin's highlights: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "12_skin/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

const Macros closed{{"SKIN_SPECULAR", "0"}, {"SKIN_SPECULAR_CLOSED", "0"}, {"SKIN_SPECULAR_TABLES", "1"}};

}  // namespace

CHECK_EXERCISE("12.schlick_fresnel", "f0 + (1 - f0) (1 - cosine)^5, with the cosine clamped to 0 and 1.") {
    Probe probe{.include = "12_skin/schlick_fresnel.glsl",
                .signature = "float schlick_fresnel(float cosine, float f0)",
                .inputs = {{1, 0.028},
                           {0, 0.028},
                           {0.5, 0.028},
                           {1.0000001, 0.028},
                           {1.5, 0.5},
                           {-1e-7, 0.028},
                           {-1, 0.028},
                           {0.5, 0},
                           {1, 0},
                           {0, 0},
                           {0.3, 1}},
                .truth = [](std::span<const double> in) { return Row{truth::schlick(in[0], in[1])}; },
                .bound = {.absolute = 3e-7, .relative = 3e-6},
                .hint = [](auto in, auto) -> std::string {
                    if (in[0] < 0) return "A cosine below 0 counts as 0: no more than all light is reflected.";
                    if (in[0] > 1) return "A cosine above 1 counts as 1.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 500; ++i) probe.inputs.push_back({random.uniform(-0.01, 1.01), random.uniform(0, 1)});
    const Table results = check.probe(probe);
    check.property(probe, results, "but from f0 to all of it is all there is",
                   [](auto in, auto out) { return out[0] >= in[1] * (1 - 1e-6) && out[0] <= 1 + 1e-6; });
}

CHECK_EXERCISE("12.beckmann",
               "tan²a = (1 - c²) / c² with c = n·h; the factor is 1 / (pi m²). Test for c near 0 before you divide.") {
    Probe probe{.include = "12_skin/beckmann.glsl",
                .signature = "float beckmann(float n_dot_h, float m)",
                .inputs = {{1, 0.3},
                           {1, 0.005},
                           {0.9999, 0.01},
                           {0.5, 0.3},
                           {0.5, 1},
                           {0.1, 1},
                           {0, 0.3},
                           {0, 1},
                           {1e-3, 0.3},
                           {1e-10, 1},
                           {1e-30, 0.005},
                           {-0.5, 0.3},
                           {-1, 1},
                           {1.0000001, 0.3},
                           {0.06, 1},
                           {0.04, 1}},
                .truth = [](std::span<const double> in) { return Row{truth::beckmann(std::min(in[0], 1.0), in[1])}; },
                .bound = {.absolute = 1e-12, .relative = 4e-5},
                .hint = [](auto in, auto out) -> std::string {
                    const double right = truth::beckmann(std::min(in[0], 1.0), in[1]);
                    if (in[0] < 0) return "No facet faces below the horizon.";
                    if (in[0] < 0.05) return "Near n·h = 0 the exponential is 0 long before cos⁴ is.";
                    if (right > 0 && std::fabs(out[0] / right - truth::skin_pi) < 0.01)
                        return "The factor 1 / pi is missing.";
                    return "";
                }};
    Random random;
    // Where rounding of n·h alone, half a unit in its last place, changes little: |d ln D / d c| · 6e-8 within the
    // bound.
    for (int i = 0; i < 1000; ++i) {
        const double m = random.logarithmic(0.02, 1), tan = m * std::sqrt(-std::log(random.uniform(0.01, 1)));
        probe.inputs.push_back({double(float(1 / std::sqrt(1 + tan * tan))), double(float(m))});
    }
    probe.bound.relative = 2e-3;  // of m = 0.02: exp's argument comes from a difference of nearly equal numbers
    const Table results = check.probe(probe);
    check.property(probe, results, "but facets are not fewer than none",
                   [](auto, auto out) { return out[0] >= 0 && std::isfinite(out[0]); });
    // The integral of D n·h over the hemisphere.
    for (const double m : {0.1, 0.3, 1.0}) {
        Probe sum = probe;
        sum.inputs.clear();
        constexpr int count = 2000;
        for (int i = 0; i < count; ++i) sum.inputs.push_back({double(float((i + 0.5) / count)), m});
        const Table found = run_probe(check_device(), sum, 1);
        double all = 0;
        for (int i = 0; i < count; ++i) all += found[size_t(i)][0] * (i + 0.5) / count * 2 * truth::skin_pi / count;
        check.expect(std::fabs(all - 1) < 0.01,
                     fmt::format("for m = {} the integral of D n·h over the hemisphere is {:.3f}, expected 1", m, all),
                     std::fabs(all - truth::skin_pi) < 0.1 ? "The factor 1 / pi is missing." : "");
    }
}

CHECK_EXERCISE("12.kelemen_szirmay_kalos",
               "h = (l + v) / |l + v|; D(n·h) F(v·h) / |l + v|², times n·l, if both are above the horizon.") {
    Probe probe{.include = "12_skin/kelemen_szirmay_kalos.glsl",
                .signature = "float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0)",
                .truth =
                    [](std::span<const double> in) {
                        return Row{truth::kelemen_szirmay_kalos(vector3(in), vector3(in.subspan(3)),
                                                                vector3(in.subspan(6)), in[9], in[10])};
                    },
                .bound = {.absolute = 2e-7, .relative = 1e-3},
                .macros = closed,
                .hint = [](auto in, auto out) -> std::string {
                    const glm::dvec3 n = vector3(in), l = vector3(in.subspan(3)), v = vector3(in.subspan(6));
                    if (glm::length(l + v) < 1e-5) return "l and v are opposite: there is no half vector.";
                    if (glm::dot(n, l) <= 0 || glm::dot(n, v) <= 0) return "Below the horizon nothing is reflected.";
                    const double right = truth::kelemen_szirmay_kalos(n, l, v, in[9], in[10]);
                    if (right > 1e-6 && std::fabs(out[0] * glm::dot(n, l) / right - 1) < 1e-3)
                        return "Multiply by n·l.";
                    const double square = glm::dot(l + v, l + v);
                    if (right > 1e-6 && std::fabs(out[0] / square / right - 1) < 1e-3) return "Divide by |l + v|².";
                    return "";
                }};
    const auto add = [&](glm::dvec3 n, glm::dvec3 l, glm::dvec3 v, double m, double f0) {
        Row row;
        append(row, glm::vec3(n));
        append(row, glm::vec3(l));
        append(row, glm::vec3(v));
        row.push_back(double(float(m)));
        row.push_back(double(float(f0)));
        probe.inputs.push_back(row);
    };
    const glm::dvec3 up(0, 0, 1), left(-1, 0, 0), right(1, 0, 0);
    add(up, up, up, 0.3, 0.028);
    add(up, left, right, 0.3, 0.028);
    add(up, up, -up, 0.3, 0.028);
    add(up, -up, up, 0.3, 0.028);
    add(up, right, up, 0.3, 0.028);
    add(up, up, right, 0.3, 0.028);
    add(right, {0.6, 0.8, 0}, {0.6, -0.8, 0}, 0.3, 0.028);
    add(right, {-0.6, 0.8, 0}, {0.6, 0.8, 0}, 0.3, 0.028);
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n(random.direction()), l(random.direction()), v(random.direction());
        // At the horizon itself rounding decides.
        if (std::fabs(glm::dot(n, l)) < 1e-3 || std::fabs(glm::dot(n, v)) < 1e-3) continue;
        add(n, l, v, random.uniform(0.1, 1), random.uniform(0, 0.2));
    }
    const Table results = check.probe(probe);
    check.property(probe, results, "but no light is taken back",
                   [](auto, auto out) { return out[0] >= 0 && std::isfinite(out[0]); });
}
