// Where the methods of chapter 02 fail: a bound where they hold, the size of the failure where they do not.
#include "02_lambert_phong/truth.h"
#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

double evaluate(const std::string& function, Row arguments) {
    const Probe probe{.include = "02_lambert_phong/" + function + ".glsl",
                      .signature = "float " + function + "(vec3 normal, vec3 to_light, vec3 to_eye, float shininess)",
                      .inputs = {std::move(arguments)}};
    return run_probe(check_device(), probe, 1)[0][0];
}

Row row(glm::dvec3 n, glm::dvec3 l, glm::dvec3 v, double shininess) {
    return {n.x, n.y, n.z, l.x, l.y, l.z, v.x, v.y, v.z, shininess};
}

const glm::dvec3 above{0, 1, 0};

}  // namespace

TEST_CASE("the usual normaliser overshoots the exact one by up to 7.5 %") {
    const auto overshoot = [](double n) { return (n + 8) / 8 / truth::blinn_phong_normalisation(n) - 1; };
    CHECK(overshoot(2) == Approx(0.042).margin(0.0005));
    CHECK(overshoot(10) == Approx(0.075).margin(0.0005));
    CHECK(overshoot(200) == Approx(0.010).margin(0.0005));
    double worst = 0;
    for (double n = 0.1; n < 1000; n *= 1.01) worst = std::max(worst, overshoot(n));
    CHECK(worst < 0.076);
}

TEST_CASE("no light is made: the lobe times its cosine integrates to at most 1 for every direction of the eye") {
    for (const double n : {1.0, 10.0, 100.0})
        for (const double eye_deg : {0.0, 30.0, 60.0, 85.0}) {
            const double a = glm::radians(eye_deg);
            const glm::dvec3 eye(std::sin(a), std::cos(a), 0);
            double sum = 0;
            constexpr int steps = 300;
            for (int i = 0; i < steps; ++i)
                for (int k = 0; k < 2 * steps; ++k) {
                    const double theta = (i + 0.5) / steps * 0.5 * std::numbers::pi;
                    const double phi = (k + 0.5) / steps * std::numbers::pi;
                    const glm::dvec3 light(std::sin(theta) * std::cos(phi), std::cos(theta),
                                           std::sin(theta) * std::sin(phi));
                    sum += truth::blinn_phong(above, light, eye, n) * std::cos(theta) * std::sin(theta);
                }
            const double area = 0.5 * std::numbers::pi / steps * std::numbers::pi / steps;
            CHECK(truth::blinn_phong_normalisation(n) * sum * area / std::numbers::pi < 1.001);
        }
}

TEST_CASE("a normal whose length has rounded to just above 1 makes no highlight above 1") {
    // Without a bound the power would make 1.1 of 1.000001.
    for (const char* lobe : {"phong", "blinn_phong"})
        CHECK(evaluate(lobe, row(above * 1.000001, above, above, 100000)) == 1);
}

TEST_CASE("a broad Phong highlight ends in a seam: it jumps where the light goes below the horizon", "[02.seam]") {
    const glm::dvec3 eye = glm::normalize(glm::dvec3(1, 0.3, 0));
    const auto at = [&](double angle) { return row(above, {-std::cos(angle), std::sin(angle), 0}, eye, 1); };
    const double jump = evaluate("phong", at(1e-4)) - evaluate("phong", at(-1e-4));
    CHECK(jump == Approx(0.958).margin(0.002));  // cos of the eye's angle to the horizon: nearly all of it
    // Times the received light, as the normalised model is, it ends in 0.
    CHECK(evaluate("blinn_phong", at(1e-4)) * std::sin(1e-4) < 2e-4);
}
