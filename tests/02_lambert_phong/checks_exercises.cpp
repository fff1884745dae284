// Checks of chapter 02: values against double precision, then properties.
#include "02_lambert_phong/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

Row directions(std::initializer_list<glm::vec3> list, std::initializer_list<double> numbers = {}) {
    Row row;
    for (const glm::vec3& v : list) append(row, v);
    row.insert(row.end(), numbers);
    return row;
}

// Whether a light in the surface, at 90 degrees, is behind it nobody says: above it or below.
const glm::vec3 up{0, 1, 0}, right{1, 0, 0}, down{0, -1, 0}, low = glm::normalize(glm::vec3(1, 0.02f, 0)),
                                                             sunk = glm::normalize(glm::vec3(1, -0.02f, 0));

// Lights and eyes all around a normal: those a student thinks of first, then random ones.
Table reflections(std::initializer_list<double> exponents) {
    const glm::vec3 slant = glm::normalize(glm::vec3(1, 1, 0)), mirrored = glm::normalize(glm::vec3(-1, 1, 0));
    const glm::vec3 steep = glm::normalize(glm::vec3(1, 2, 0));  // cosine -0.6: of 0, rounding would decide
    Table table;
    for (const double n : exponents) {
        table.push_back(directions({up, up, up}, {n}));
        table.push_back(directions({up, slant, mirrored}, {n}));
        table.push_back(directions({up, slant, slant}, {n}));
        table.push_back(directions({up, low, up}, {n}));
        table.push_back(directions({up, sunk, up}, {n}));
        table.push_back(directions({up, sunk, -right}, {n}));
        table.push_back(directions({up, down, up}, {n}));
        table.push_back(directions({up, -slant, mirrored}, {n}));
        table.push_back(directions({up, up, down}, {n}));
        table.push_back(directions({up, steep, -steep}, {n}));  // no half vector, and the light in front
    }
    Random random;
    while (table.size() < 4000)
        table.push_back(
            directions({random.direction(), random.direction(), random.direction()}, {random.logarithmic(0.1, 1000)}));
    return table;
}

using Lobe = double (*)(glm::dvec3, glm::dvec3, glm::dvec3, double);

Probe lobe_probe(const std::string& name, Lobe lobe) {
    return {.include = "02_lambert_phong/" + name + ".glsl",
            .signature = "float " + name + "(vec3 normal, vec3 to_light, vec3 to_eye, float shininess)",
            .inputs = reflections({0, 1, 2, 10, 32, 1000}),
            .truth =
                [lobe](std::span<const double> in) {
                    return Row{lobe(vector3(in, 0), vector3(in, 3), vector3(in, 6), in[9])};
                },
            // A direction's rounding (6e-8) moves the cosine, which the power multiplies by up to 1000.
            .bound = {.absolute = 3e-4},
            .hint = [lobe](std::span<const double> in, std::span<const double> got) -> std::string {
                const double facing = glm::dot(vector3(in, 0), vector3(in, 3));
                const double truth = lobe(vector3(in, 0), vector3(in, 3), vector3(in, 6), in[9]);
                if (facing < 0 && got[0] != 0) return "here the light is behind the surface: no highlight";
                if (truth == 0 && got[0] != 0)
                    return "here the cosine is not above 0: no highlight, whatever the exponent";
                if (lobe(vector3(in, 0), vector3(in, 3), vector3(in, 6), 4 * in[9]) == got[0])
                    return "the cosine is right, the exponent is four times too large";
                if (truth == 1 && facing > 0.999) return "light, eye and normal are one direction: the cosine is 1";
                return "";
            }};
}

void check_lobe(Check& check, const Probe& probe) {
    const Table results = check.probe(probe);
    check.property(probe, results, "but a highlight is between 0 and 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1; });
    check.property(probe, results, "but the light is behind the surface",
                   [](auto in, auto out) { return glm::dot(vector3(in, 0), vector3(in, 3)) > -1e-6 || out[0] == 0; });
    // Helmholtz: light and eye may change places, but for a light behind the surface.
    Probe swapped = probe;
    for (Row& row : swapped.inputs)
        for (size_t i = 0; i < 3; ++i) std::swap(row[3 + i], row[6 + i]);
    const Table others = run_probe(check_device(), swapped, 1);
    size_t row = 0;
    check.property(probe, results, "but it changes when light and eye change places", [&](auto in, auto out) {
        const double other = others[row++][0];
        const glm::dvec3 n = vector3(in, 0);
        const bool both_above = glm::dot(n, vector3(in, 3)) > 1e-6 && glm::dot(n, vector3(in, 6)) > 1e-6;
        return !both_above || std::fabs(out[0] - other) < 6e-4;
    });
}

}  // namespace

CHECK_EXERCISE(
    "02.lambert",
    "the dot product of two unit vectors is the cosine between them; a light behind the surface adds nothing") {
    Probe probe{.include = "02_lambert_phong/lambert.glsl",
                .signature = "float lambert(vec3 normal, vec3 to_light)",
                .inputs = {directions({up, up}), directions({up, right}), directions({up, down})},
                .truth = [](std::span<const double> in) { return Row{truth::lambert(vector3(in, 0), vector3(in, 3))}; },
                // A direction's length is off by 6e-8, and a formula may square, add and take away.
                .bound = {.absolute = 1e-6},
                .hint = [](auto in, auto got) -> std::string {
                    const double cosine = glm::dot(vector3(in, 0), vector3(in, 3));
                    if (cosine < 0 && got[0] < 0) return "negative light takes away what other lamps give: clamp at 0";
                    if (cosine < 0) return "the light is behind the surface: 0, not its absolute value";
                    return "the cosine between two vectors of length 1 is their dot product";
                }};
    Random random;
    for (int i = 0; i < 2000; ++i) probe.inputs.push_back(directions({random.direction(), random.direction()}));
    const Table results = check.probe(probe);
    check.property(probe, results, "but a cosine that counts is between 0 and 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1.000001; });
}

CHECK_EXERCISE("02.phong",
               "reflect(-to_light, normal) is the mirror direction; test that the cosine is above 0 before pow") {
    check_lobe(check, lobe_probe("phong", truth::phong));
}

CHECK_EXERCISE("02.blinn_phong", "the half vector is to_light + to_eye, normalised; what if this sum has length 0?") {
    check_lobe(check, lobe_probe("blinn_phong", truth::blinn_phong));
    Probe factor{.include = "02_lambert_phong/blinn_phong.glsl",
                 .signature = "float blinn_phong_normalisation(float shininess)",
                 .inputs = {{0}, {1}, {2}, {10}, {200}, {4096}},
                 .truth = [](std::span<const double> in) { return Row{truth::blinn_phong_normalisation(in[0])}; },
                 .bound = {.relative = 1e-5}};
    Random random;
    for (int i = 0; i < 500; ++i) factor.inputs.push_back({random.logarithmic(0.01, 4096)});
    const Table results = check.probe(factor);
    check.property(
        factor, results, "but with it the surface does not reflect all light, seen from above", [](auto in, auto out) {
            return std::fabs(out[0] / truth::blinn_phong_normalisation_by_quadrature(in[0], 4000) - 1) < 1e-3;
        });
}

CHECK_EXERCISE("02.wrapped_diffuse", "shift the cosine by wrap, divide so that 1 stays 1, and clamp before pow") {
    Probe amount{.include = "02_lambert_phong/wrapped_diffuse.glsl",
                 .signature = "float wrapped_diffuse(float cosine, float wrap, float power)",
                 .inputs = {{1, 0, 1},
                            {0, 0, 1},
                            {-1, 0, 1},
                            {0, 1, 1},
                            {-1, 1, 1},
                            {0, 0.5, 1},
                            {-0.5, 0.5, 2},
                            {-0.8, 0.5, 2},
                            {0.3, 0, 1}},
                 .truth = [](std::span<const double> in) { return Row{truth::wrapped_diffuse(in[0], in[1], in[2])}; },
                 .bound = {.absolute = 2e-6},
                 .hint = [](auto in, auto got) -> std::string {
                     if (in[0] < -in[1] && got[0] != 0) return "cosine + wrap is negative here: no light";
                     const double once = std::max((in[0] + in[1]) / (1 + in[1]), 0.0);
                     if (std::fabs(got[0] - std::pow(std::clamp(in[0] + in[1], 0.0, 1.0), in[2])) < 1e-5)
                         return "divide by 1 + wrap, so that the brightest point is 1";
                     if (std::fabs(got[0] - once) < 1e-5) return "the power is missing";
                     if (std::fabs(got[0] - std::pow(std::max(in[0], 0.0), in[2])) < 1e-5) return "the wrap is missing";
                     return "";
                 }};
    Probe tint{.include = amount.include,
               .signature = "vec3 wrapped_tint(float cosine, vec3 tint)",
               .inputs = {{1, 1, 0.3, 0.2}, {0, 1, 0.3, 0.2}, {-1, 1, 0.3, 0.2}, {0.5, 0, 0, 0}},
               .truth =
                   [](std::span<const double> in) {
                       Row row;
                       append(row, truth::wrapped_tint(in[0], vector3(in, 1)));
                       return row;
                   },
               .bound = {.absolute = 1e-6}};
    Random random;
    for (int i = 0; i < 1000; ++i) {
        amount.inputs.push_back({random.uniform(-1, 1), random.uniform(0, 1), random.logarithmic(0.5, 8)});
        tint.inputs.push_back(
            {random.uniform(-1, 1), random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
    }
    const Table results = check.probe(amount);
    check.property(amount, results, "but it must be between 0 and 1",
                   [](auto, auto out) { return out[0] >= 0 && out[0] <= 1.000001; });
    check.probe(tint);
    // Turning towards the light never makes a surface darker.
    Probe turning = amount;
    turning.inputs.clear();
    for (int i = 0; i <= 200; ++i) turning.inputs.push_back({-1 + 0.01 * i, 0.6, 1.5});
    const Table brightness = run_probe(check_device(), turning, 1);
    double before = 0;
    check.property(turning, brightness, "less than when turned further away", [&](auto, auto out) {
        const bool rises = out[0] >= before - 1e-6;
        before = out[0];
        return rises;
    });
}
