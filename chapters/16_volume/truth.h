// References in double precision for chapter 16.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace lightwalk::truth {

/// Where a ray is inside a ball around the origin: enters and leaves, in metres along it; both 0 where it misses.
inline glm::dvec2 ray_shell(glm::dvec3 origin, glm::dvec3 direction, double radius) {
    direction = glm::normalize(direction);
    const double nearest = -glm::dot(origin, direction);
    const glm::dvec3 beside = origin + nearest * direction;
    const double rest = radius * radius - glm::dot(beside, beside);
    if (rest <= 0) return glm::dvec2(0);
    return glm::max(glm::dvec2(nearest - std::sqrt(rest), nearest + std::sqrt(rest)), 0.0);
}

/// The opacity of a layer `ratio` times as long as one of `opacity`.
inline double correct_opacity(double opacity, double ratio) {
    if (ratio == 0) return 0;
    return opacity >= 1 ? 1 : -std::expm1(ratio * std::log1p(-opacity));
}

enum class Weight { quintic, cubic, linear };

/// The numbers of lattice_4d.glsl: pcg4d, -1 to 1.
inline double lattice_4d(glm::ivec4 cell) {
    const auto multiply_add = [](uint32_t x) { return x * 1664525u + 1013904223u; };
    uint32_t v[4] = {multiply_add(uint32_t(cell.x)), multiply_add(uint32_t(cell.y)), multiply_add(uint32_t(cell.z)),
                     multiply_add(uint32_t(cell.w))};
    const auto mix = [&] {
        const uint32_t x = v[0] + v[1] * v[3], y = v[1] + v[2] * v[0], z = v[2] + v[0] * v[1], w = v[3] + v[1] * v[2];
        v[0] = x;
        v[1] = y;
        v[2] = z;
        v[3] = w;
    };
    mix();
    for (uint32_t& one : v) one ^= one >> 16u;
    mix();
    return double(v[0] >> 8u) * 2.0 / 16777215.0 - 1.0;
}

/// Value noise in four dimensions.
inline double noise_4d(glm::ivec4 cell, glm::dvec4 f, Weight weight = Weight::quintic) {
    double sum = 0;
    for (int corner = 0; corner < 16; ++corner) {
        double share = 1;
        glm::ivec4 at = cell;
        for (int axis = 0; axis < 4; ++axis) {
            const double t = f[axis];
            const double s = weight == Weight::linear  ? t
                             : weight == Weight::cubic ? t * t * (3 - 2 * t)
                                                       : t * t * t * (t * (6 * t - 15) + 10);
            const int upper = corner >> axis & 1;
            share *= upper ? s : 1 - s;
            at[axis] = int(uint32_t(at[axis]) + uint32_t(upper));  // wraps around, as the device does
        }
        sum += share * lattice_4d(at);
    }
    return sum;
}

/// Contribution of a step with linearly changing density: light, and opacity. 40,000 layers.
inline glm::dvec4 preintegrate(std::span<const glm::vec4> transfer, double front, double back, double ratio) {
    const int layers = 40000;
    glm::dvec3 light(0);
    double through = 1;
    for (int i = 0; i < layers; ++i) {
        const double density = front + (back - front) * (i + 0.5) / layers;
        const double at = density * double(transfer.size() - 1);
        const size_t below = std::min(size_t(at), transfer.size() - 2);
        const glm::dvec4 looks =
            glm::mix(glm::dvec4(transfer[below]), glm::dvec4(transfer[below + 1]), at - double(below));
        const double opacity = looks.a <= 0 ? 0 : correct_opacity(std::min(looks.a, 1.0), ratio / layers);
        light += through * opacity * glm::dvec3(looks);
        through *= 1 - opacity;
    }
    return {light, 1 - through};
}

/// Light and transmittance along a ray of `length` metres with extinction (1/m) and colour as functions of position,
/// by 2^16 midpoints.
struct Along {
    double light = 0, through = 1;
};
inline Along march(double length, const std::function<double(double)>& extinction,
                   const std::function<double(double)>& color, int steps = 1 << 16) {
    Along sum;
    for (int i = 0; i < steps; ++i) {
        const double at = (i + 0.5) * length / steps, opacity = -std::expm1(-extinction(at) * length / steps);
        sum.light += sum.through * opacity * color(at);
        sum.through *= 1 - opacity;
    }
    return sum;
}

}  // namespace lightwalk::truth
