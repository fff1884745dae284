// The dipole and the six Gaussians against random walks: how far they are from what light does in a half space.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "12_skin/truth.h"
#include "catch.h"

namespace {

constexpr double eta = 1.3;

/// Fresnel's reflectance of light without polarisation, from inside.
double reflectance(double cosine) {
    const double sine2 = eta * eta * (1 - cosine * cosine);
    if (sine2 >= 1) return 1;
    const double out = std::sqrt(1 - sine2);
    const double s = (eta * cosine - out) / (eta * cosine + out), p = (eta * out - cosine) / (eta * out + cosine);
    return 0.5 * (s * s + p * p);
}

struct LeavingBeam {
    double share;                    ///< of the light that entered
    double half_mm, nine_tenths_mm;  ///< radii within which these parts of the share leave
};

/// `light`: by radius, in order; `unit`: one unit of it, as a share of the light that entered.
LeavingBeam of_light(const std::vector<std::pair<double, double>>& light, double unit) {
    LeavingBeam leaving{};
    double sum = 0, within = 0;
    for (const auto& [radius, share] : light) sum += share;
    for (const auto& [radius, share] : light) {
        within += share;
        if (within < 0.5 * sum) leaving.half_mm = radius;
        if (within < 0.9 * sum) leaving.nine_tenths_mm = radius;
    }
    leaving.share = sum * unit;
    return leaving;
}

/// Of a beam that has entered a half space along its normal; scattering is isotropic, coefficients per mm.
LeavingBeam walk(double scattering, double absorption, int walks) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double extinction = scattering + absorption;
    std::vector<std::pair<double, double>> left;  // radius, share
    for (int i = 0; i < walks; ++i) {
        double x = 0, y = 0, z = 0, dx = 0, dy = 0, dz = 1, share = 1;
        while (share > 1e-4) {
            const double way = -std::log(1 - uniform(random)) / extinction;
            if (z + dz * way < 0) {
                const double to = -z / dz;
                x += dx * to;
                y += dy * to;
                z = 0;
                if (uniform(random) >= reflectance(-dz)) {
                    left.emplace_back(std::hypot(x, y), share);
                    break;
                }
                dz = -dz;  // a free path has no memory
                continue;
            }
            x += dx * way;
            y += dy * way;
            z += dz * way;
            share *= scattering / extinction;
            const double turn = 2 * std::numbers::pi * uniform(random);
            dz = 2 * uniform(random) - 1;
            dx = std::sqrt(1 - dz * dz) * std::cos(turn);
            dy = std::sqrt(1 - dz * dz) * std::sin(turn);
        }
    }
    std::sort(left.begin(), left.end());
    return of_light(left, 1.0 / walks);
}

/// By docs/12_skin.md's formula, in rings of equal ratio.
LeavingBeam dipole(double scattering, double absorption) {
    const double extinction = scattering + absorption, tr = std::sqrt(3 * absorption * extinction);
    const double inside = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
    const double zr = 1 / extinction, zv = zr * (1 + 4.0 / 3 * (1 + inside) / (1 - inside));
    const auto source = [&](double z, double r) {
        const double d = std::hypot(r, z);
        return z * (1 + tr * d) * std::exp(-tr * d) / (d * d * d);
    };
    std::vector<std::pair<double, double>> rings;
    for (double r = 1e-4; r < 100; r *= 1.002) {
        const double middle = r * 1.001, wide = r * 0.002;
        const double light = scattering / extinction * 0.5 * (source(zr, middle) + source(zv, middle)) * middle * wide;
        rings.emplace_back(middle, light);
    }
    return of_light(rings, 1);
}

/// By the sum of six Gaussians of channel k, in rings of equal ratio.
LeavingBeam six_gaussians(int k) {
    std::vector<std::pair<double, double>> rings;
    for (double r = 1e-4; r < 100; r *= 1.002) {
        const double middle = r * 1.001;
        const double ring = 2 * std::numbers::pi * middle * r * 0.002;
        rings.emplace_back(middle, lightwalk::truth::profile(middle)[k] * ring);
    }
    return of_light(rings, 1);
}

}  // namespace

TEST_CASE("skin: the dipole and six Gaussians against random walks in a half space", "[12.walks]") {
    const double scattering[] = {0.74, 0.88, 1.01}, absorption[] = {0.032, 0.17, 0.48},
                 reflected[] = {0.44, 0.23, 0.13}, measured[] = {0.438, 0.213, 0.115}, nearer[] = {0.94, 0.69, 0.50},
                 gaussians[] = {0.694, 0.166, 0.123}, gaussians_most[] = {2.76, 0.580, 0.355};
    for (int k = 0; k < 3; ++k) {
        const LeavingBeam formula = dipole(scattering[k], absorption[k]), sum = six_gaussians(k),
                          right = walk(scattering[k], absorption[k], 200000);
        fmt::print("six Gaussians {:.3f}, half {:.2f}, 90% {:.2f} mm; ", sum.share, sum.half_mm, sum.nine_tenths_mm);
        CHECK(sum.share == Approx(1).margin(0.002));
        CHECK(sum.half_mm == Approx(gaussians[k]).epsilon(0.01));
        CHECK(sum.nine_tenths_mm == Approx(gaussians_most[k]).epsilon(0.01));
        fmt::print("dipole {:.3f}, half {:.2f}, 90% {:.2f} mm; walks {:.3f}, half {:.2f}, 90% {:.2f} mm\n",
                   formula.share, formula.half_mm, formula.nine_tenths_mm, right.share, right.half_mm,
                   right.nine_tenths_mm);
        CHECK(formula.share == Approx(reflected[k]).margin(0.005));
        CHECK(right.share == Approx(measured[k]).margin(0.004));
        CHECK(right.half_mm / formula.half_mm == Approx(nearer[k]).margin(0.03));
        CHECK(right.nine_tenths_mm / formula.nine_tenths_mm == Approx(1).margin(0.08));
    }
}
