#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

// P. J. Barry and R. N. Goldman, "A recursive evaluation algorithm for a class of Catmull-Rom splines", SIGGRAPH 1988.
glm::dvec3 catmull_rom(const FourKeys& keys, double t) {
    const auto& [p, k] = keys;
    const auto mix = [&](glm::dvec3 a, glm::dvec3 b, double ta, double tb) {
        return tb > ta ? ((tb - t) * a + (t - ta) * b) / (tb - ta) : b;
    };
    const glm::dvec3 a1 = k[1] > k[0] ? mix(p[0], p[1], k[0], k[1]) : p[1];
    const glm::dvec3 a2 = mix(p[1], p[2], k[1], k[2]);
    const glm::dvec3 a3 = k[3] > k[2] ? mix(p[2], p[3], k[2], k[3]) : p[2];
    return mix(mix(a1, a2, k[0], k[2]), mix(a2, a3, k[1], k[3]), k[1], k[2]);
}

}  // namespace lightwalk::solution
