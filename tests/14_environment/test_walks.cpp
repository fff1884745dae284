// GGX's microsurface by random walks, which know neither the split sum nor a formula for what several microfacets send.
#include <fmt/core.h>

#include <array>
#include <random>

#include "light_fixture.h"

using namespace lightwalk;

namespace {

constexpr std::array<double, 4> f0s = {0.04, 0.5, 0.8, 1.0};

/// Shares of light from one direction that leave after one microfacet, and after any number, for each of `f0s`.
struct Leaving {
    std::array<double, 4> once{}, all{};
};

/// Smith's lambda of GGX for a direction above or below the mean surface z = 0.
double lambda(glm::dvec3 w, double alpha) {
    const double a = w.z / (alpha * std::sqrt(1 - w.z * w.z));
    return 0.5 * (std::copysign(std::sqrt(1 + 1 / (a * a)), a) - 1);
}

/// E. Heitz, J. Hanika, E. d'Eon and C. Dachsbacher, "Multiple-Scattering Microfacet BSDFs with the Smith Model", SIGGRAPH 2016.
/// A height is the share of the surface below it. Normals: J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with
/// Spherical Caps", HPG 2023. Fresnel's term is Schlick's.
Leaving walk(double n_dot_v, double alpha, int walks) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    Leaving leaving;
    for (int i = 0; i < walks; ++i) {
        std::array<double, 4> share = {1, 1, 1, 1};
        glm::dvec3 w = {-std::sqrt(1 - n_dot_v * n_dot_v), 0, -n_dot_v};
        double height = 1;
        for (int bounces = 0; bounces < 200; ++bounces) {
            const double u = uniform(random), l = lambda(w, alpha);
            if (w.z > 0 && u > 1 - std::pow(height, l)) {
                for (size_t k = 0; k < f0s.size(); ++k) {
                    leaving.all[k] += share[k] / walks;
                    if (bounces == 1) leaving.once[k] += share[k] / walks;
                }
                break;
            }
            height /= std::pow(1 - u, 1 / l);
            const glm::dvec3 to = -w, wide = glm::normalize(glm::dvec3(alpha * to.x, alpha * to.y, to.z));
            const double turn = truth::around * uniform(random);
            const double z = (1 - uniform(random)) * (1 + wide.z) - wide.z, r = std::sqrt(std::max(1 - z * z, 0.0));
            const glm::dvec3 h = glm::dvec3(r * std::cos(turn), r * std::sin(turn), z) + wide;
            const glm::dvec3 m = glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, std::max(h.z, 0.0)));
            const double cosine = std::clamp(glm::dot(to, m), 0.0, 1.0);
            for (size_t k = 0; k < f0s.size(); ++k) share[k] *= f0s[k] + (1 - f0s[k]) * std::pow(1 - cosine, 5);
            w = glm::normalize(2 * cosine * m - to);
        }
    }
    return leaving;
}

}  // namespace

TEST_CASE_METHOD(OnLight, "a microsurface by random walks: one microfacet as the split sum has it, and several",
                 "[14.walks]") {
    load("", glm::vec3(1.0f));
    double most[2] = {}, brightest = 0, of_lamps = 0;  // errors for alpha up to 0.5, and for 1
    for (const double alpha : {0.1, 0.25, 0.5, 1.0}) {
        double kept = 0;  // what a white surface sends after one microfacet, of light from everywhere
        for (int i = 0; i < 24; ++i) kept += walk(std::sqrt((i + 0.5) / 24), alpha, 4000).once.back() / 24;
        for (const double n_dot_v : {0.1, 0.3, 0.6, 0.95}) {
            const Leaving right = walk(n_dot_v, alpha, 40000);
            std::vector<LookedAt> surfaces;
            for (const double f0 : f0s)
                surfaces.push_back(
                    {{0, 0, 1}, {std::sqrt(1 - n_dot_v * n_dot_v), 0, n_dot_v}, glm::vec3(float(f0)), float(alpha)});
            light.method.set("dominant");
            const auto once = shown(surfaces);
            light.method.set("multiscatter");
            const auto all = shown(surfaces);
            for (size_t k = 0; k < f0s.size(); ++k) {
                const double off = double(all[k].specular.g) - right.all[k], mean = f0s[k] + (1 - f0s[k]) / 21;
                // What lamps have: Kulla and Conty, 2017.
                const double lamps =
                    right.once[k] + (1 - right.once.back()) * mean * mean * kept / (1 - mean * (1 - kept));
                CAPTURE(alpha, n_dot_v, f0s[k], all[k].specular.g, lamps, right.all[k]);
                CHECK(double(once[k].specular.g) == Approx(right.once[k]).margin(0.01));
                if (alpha > 0.5 && n_dot_v > 0.9)
                    fmt::print("alpha 1, from above, f0 {:.2f}: {:.2f}, by walks {:.2f}\n", f0s[k], all[k].specular.g,
                               right.all[k]);
                most[alpha > 0.5] = std::max(most[alpha > 0.5], -off);
                brightest = std::max(brightest, off);
                of_lamps = std::max(of_lamps, std::abs(lamps - right.all[k]));
            }
            CHECK(right.all.back() == Approx(1).margin(1e-9));  // white keeps all: no walk is lost
        }
    }
    fmt::print(
        "several microfacets: too dark by {:.3f}, by {:.3f} with alpha 1, too bright by {:.3f}; for lamps {:.3f} off\n",
        most[0], most[1], brightest, of_lamps);
    CHECK(most[0] < 0.028);
    CHECK(most[1] == Approx(0.069).margin(0.006));
    CHECK(brightest < 0.004);
    CHECK(of_lamps < 0.05);
}
