#include "14_environment/paint_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lightwalk {
namespace {

constexpr double walk_pi = glm::pi<double>();

// Fresnel's reflectance of unpolarised light at a smooth boundary; `index`: of the far side over that of the near one.
double fresnel(double cosine, double index) {
    const double sine2 = (1 - cosine * cosine) / (index * index);
    if (sine2 >= 1) return 1;
    const double through = std::sqrt(1 - sine2);
    const double s = (cosine - index * through) / (cosine + index * through);
    const double p = (through - index * cosine) / (through + index * cosine);
    return 0.5 * (s * s + p * p);
}

glm::dvec3 refracted(glm::dvec3 w, double index) {
    const double x = w.x / index, y = w.y / index;
    return {x, y, std::sqrt(1 - x * x - y * y)};
}

// Flakes as the SGGX microflake distribution: E. Heitz, J. Dupuy, C. Crassin and C. Dachsbacher, "The SGGX Microflake
// Distribution", SIGGRAPH 2015. Collisions per unit of length, and the density of normals.
double extinction(const WalkedPaint& paint, glm::dvec3 w) {
    const double a2 = paint.alpha * paint.alpha;
    return 1 - paint.flakes + paint.flakes * std::sqrt(a2 + (1 - a2) * w.z * w.z);
}

double flake_density(const WalkedPaint& paint, glm::dvec3 m) {
    const double a2 = paint.alpha * paint.alpha, d = (m.x * m.x + m.y * m.y) / a2 + m.z * m.z;
    return 1 / (walk_pi * a2 * d * d);
}

struct Random {
    std::mt19937 engine;
    std::uniform_real_distribution<double> uniform{0, 1};
    double operator()() { return uniform(engine); }
};

glm::dvec3 anywhere(Random& random) {
    const double z = 1 - 2 * random(), r = std::sqrt(std::max(1 - z * z, 0.0)), turn = 2 * walk_pi * random();
    return {r * std::cos(turn), r * std::sin(turn), z};
}

// Normal of a flake that is met from direction `to`: an ellipsoid is a stretched sphere, whose visible points fill a disc.
glm::dvec3 visible_normal(const WalkedPaint& paint, glm::dvec3 to, Random& random) {
    const glm::dvec3 stretch(paint.alpha, paint.alpha, 1), up = glm::normalize(stretch * to);
    const glm::dvec3 x = glm::normalize(
                         glm::cross(std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0), up)),
                     y = glm::cross(up, x);
    const double u = random(), r = std::sqrt(u), turn = 2 * walk_pi * random();
    return glm::normalize(stretch * (r * std::cos(turn) * x + r * std::sin(turn) * y + std::sqrt(1 - u) * up));
}

}  // namespace

glm::dvec3 walked_brdf(const WalkedPaint& paint, const LightAndView& seen, int walks, uint32_t seed) {
    const glm::dvec3 into = -refracted(seen.to_light, paint.index), out = refracted(seen.to_eye, paint.index);
    const double out_per_depth = extinction(paint, out) / out.z;
    const glm::dvec3 by_pigment = (1 - paint.flakes) * paint.pigment / (4 * walk_pi),
                     by_flakes = 0.25 * paint.flakes * paint.flake;
    Random random{std::mt19937(seed)};
    glm::dvec3 sum(0);
    for (int i = 0; i < walks; ++i) {
        glm::dvec3 w = into, weight(1);
        double depth = 0;
        for (;;) {
            const double density = extinction(paint, w);
            depth += w.z * std::log(1 - random()) / density;
            if (depth < 0) {
                if (random() >= fresnel(w.z, 1 / paint.index)) break;
                w.z = -w.z, depth = 0;
                continue;
            }
            // Each collision sends light straight towards the camera; then the path goes on.
            sum += weight * (by_pigment + by_flakes * flake_density(paint, glm::normalize(out - w))) / density *
                   std::exp(-out_per_depth * depth);
            if (random() * density < 1 - paint.flakes) {
                weight *= paint.pigment;
                w = anywhere(random);
            } else {
                weight *= paint.flake;
                w = glm::reflect(w, visible_normal(paint, -w, random));
            }
            const double most = std::max({weight.r, weight.g, weight.b});
            if (random() >= most) break;
            weight /= most;
        }
    }
    const double coat = (1 - fresnel(seen.to_light.z, paint.index)) * (1 - fresnel(seen.to_eye.z, paint.index));
    return sum * coat / (walks * paint.index * paint.index * out.z);
}

MeasuredBrdf measure_by_walks(const WalkedPaint& paint, glm::ivec3 cells, int walks) {
    MeasuredBrdf brdf{cells, {}};
    brdf.values.assign(size_t(cells.x) * size_t(cells.y) * size_t(cells.z), glm::dvec3(-1));
    each_cell(cells, [&](glm::ivec3 cell) {
        const LightAndView seen = directions_of(cells, cell);
        const int mirrored = cells.z - 1 - cell.z;  // light and camera exchanged
        if (!seen.above()) return;
        brdf.at(cell) = mirrored < cell.z ? brdf.at({cell.x, cell.y, mirrored}) : walked_brdf(paint, seen, walks);
    });
    return brdf;
}

}  // namespace lightwalk
