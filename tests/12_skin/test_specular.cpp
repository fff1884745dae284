// The light that skin's surface reflects: tables, limits and energy.
#include <fmt/core.h>

#include "../common/gpu_fixture.h"
#include "12_skin/truth.h"
#include "common/check/probe.h"

using namespace lightwalk;

namespace {

Table ask(const char* include, const char* signature, Table inputs, size_t outputs) {
    const Probe probe{.include = include,
                      .signature = signature,
                      .inputs = std::move(inputs),
                      .macros = {{"SKIN_SPECULAR", "0"}, {"SKIN_SPECULAR_TABLES", "1"}}};
    return run_probe(validated_device(), probe, outputs);
}

}  // namespace

TEST_CASE("half of the tenth root clips where the distribution passes 1024: m below .0176, without 1/pi below .03125") {
    Table inputs;
    for (const double m : {0.0150, 0.0176, 0.0177, 0.0300, 0.0320}) inputs.push_back({truth::beckmann(1, m)});
    for (const double m : {0.0312, 0.0313}) inputs.push_back({truth::skin_pi * truth::beckmann(1, m)});
    const Table codes = ask("12_skin/skin.glsl", "float encode_facets(float facets)", inputs, 1);
    CHECK(codes[0][0] > 1);
    CHECK(codes[1][0] > 1);
    CHECK(codes[2][0] < 1);
    CHECK(codes[3][0] < 1);
    CHECK(codes[5][0] > 1);
    CHECK(codes[6][0] < 1);
}

TEST_CASE("8 bits of the tenth root: a distribution from the table is off by at most 5% where it matters",
          "[12.tenth_root]") {
    double worst = 0;
    for (const double m : {0.1, 0.2, 0.3, 0.5})
        for (double c = 0.5; c <= 1; c += 0.01) {
            const double right = truth::beckmann(c, m);
            if (right < 0.01) continue;
            const double code = std::round(255 * 0.5 * std::pow(right, 0.1)) / 255;
            worst = std::max(worst, std::fabs(std::pow(2 * code, 10) / right - 1));
        }
    fmt::print("the table's largest relative error by rounding: {:.3f}\n", worst);
    CHECK(worst < 0.07);
    CHECK(worst > 0.02);  // and that is no rounding error: ten times that of the code
}

TEST_CASE("with F = 1 the BRDF reflects at most what arrives; without its 1/pi, pi times that", "[12.brdf_bound]") {
    for (const double m : {0.15, 0.3, 0.6}) {
        const double all = truth::reflected(0.9, m, 1, 100);
        INFO(m);
        CHECK(all < 1.02);
        CHECK(all > 0.6);
        CHECK(truth::skin_pi * all > 2);
    }
}

TEST_CASE("F0 of .0028, as it was once printed, leaves a tenth of the highlight", "[12.small_f0]") {
    const glm::dvec3 n(0, 0, 1), v(0, 0.6, 0.8);
    const double right = truth::kelemen_szirmay_kalos(n, {0, -0.6, 0.8}, v, 0.3, 0.028);
    const double printed = truth::kelemen_szirmay_kalos(n, {0, -0.6, 0.8}, v, 0.3, 0.0028);
    CHECK(printed / right > 0.09);
    CHECK(printed / right < 0.13);
}
