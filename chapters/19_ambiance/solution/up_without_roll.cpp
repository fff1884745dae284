#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

// Rotates `up` about from x to by the angle between them; up . from is 0. The sum's length is 2 near 0 degrees and 0 at
// 180, and its square is 2 + 2 cos.
glm::dvec3 up_without_roll(glm::dvec3 up, glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec3 sum = from + to;
    const double square = glm::dot(sum, sum);
    if (square < 1e-12) return up;
    const glm::dvec3 turned = up - (2 * glm::dot(up, to) / square) * sum;
    return glm::normalize(turned - glm::dot(turned, to) * to);
}

}  // namespace lightwalk::solution
