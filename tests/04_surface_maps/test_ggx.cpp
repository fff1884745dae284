// Lights on microfacets: published formulas in double precision.
#include <glm/gtc/constants.hpp>

#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

constexpr double pi = glm::pi<double>();

// Smith's masking by Heitz' auxiliary function (JCGT 3(2), 2014, equations 72 and 99), and Walter's density.
double lambda(double cosine, double alpha) {
    const double tangent2 = (1 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
}

Row reflected(const glm::dvec3& n, const glm::dvec3& v, double alpha, const glm::dvec3& f0, const glm::dvec3& l) {
    const double n_l = glm::dot(n, l), n_v = glm::dot(n, v);
    if (n_l <= 0) return Row(6, 0.0);
    const glm::dvec3 h = glm::normalize(l + v);
    const double n_h = glm::dot(n, h), c = n_h * n_h * (alpha * alpha - 1) + 1;
    const double density = alpha * alpha / (pi * c * c);
    const double seen = 1 / (1 + lambda(n_l, alpha) + lambda(n_v, alpha));
    const glm::dvec3 fresnel = f0 + (1.0 - f0) * std::pow(1 - glm::dot(v, h), 5);
    Row row;
    append(row, glm::dvec3(n_l));
    append(row, fresnel * (pi * n_l * density * seen / (4 * n_l * n_v)));
    return row;
}

Row row_of(const glm::dvec3& n, const glm::dvec3& v, double alpha, const glm::dvec3& f0, const glm::dvec3& l) {
    Row row;
    append(row, l);
    append(row, f0);
    append(row, n);
    append(row, v);
    row.push_back(2 / (alpha * alpha) - 2);
    return row;
}

const glm::dvec3 up(0, 0, 1);
glm::dvec3 direction(double polar, double around) {
    return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
}

Probe ggx() {
    return {.include = "04_surface_maps/microfacets.glsl",
            .before = R"(#include "common/structs.h"
                #include "04_surface_maps/microfacets.glsl"
                Reflected ggx(vec3 to_light, vec3 f0, Surface surface) {
                    vec3 none = vec3(0.0);
                    Coat coat = Coat(f0, none, none, vec3(1.0), none, vec2(0.0));
                    return reflect_by_ggx(surface, coat, vec2(0.0), to_light);
                }
)",
            .signature = "Reflected ggx(vec3 to_light, vec3 f0, Surface surface)",  // a struct comes last
            .bound = {.absolute = 1e-5, .relative = 2e-3}};
}

}  // namespace

TEST_CASE("microfacets: Fresnel, density and masking as published") {
    Probe probe = ggx();
    Random random;
    for (int i = 0; i < 1000; ++i)
        probe.inputs.push_back(row_of(up, direction(random.uniform(0, 1.4), random.uniform(0, 6.28)),
                                      random.uniform(0.05, 1), glm::dvec3(random.uniform(0, 1), 0.04, 1),
                                      direction(random.uniform(0, 1.7), random.uniform(0, 6.28))));
    probe.truth = [](std::span<const double> in) {
        const double alpha = std::sqrt(2 / (in[12] + 2));
        return reflected(vector3(in, 6), vector3(in, 9), alpha, vector3(in, 3), vector3(in, 0));
    };
    CHECK(worst_of(probe, run_probe(check_device(), probe, 6)) == "");
}
