// Exercise 19.catmull_rom: a smooth curve through keys at any knots.
// Starter: the curve is a chain of straight lines, and the camera jerks at each key.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [catmull_rom]
// The point at parameter t of the Catmull-Rom curve through four keys p0 p1 p2 p3, which it
// passes at the knots t0 <= t1 <= t2 <= t3. Called with t1 <= t <= t2 alone: there the curve
// runs from p1 to p2.
//
// Barry and Goldman's pyramid gives it by three rounds of linear interpolation. With
//
//     mix(a, b, ta, tb) = ((tb - t) a + (t - ta) b) / (tb - ta)
//
//     a1 = mix(p0, p1, t0, t1)    a2 = mix(p1, p2, t1, t2)    a3 = mix(p2, p3, t2, t3)
//     b1 = mix(a1, a2, t0, t2)    b2 = mix(a2, a3, t1, t3)
//     curve = mix(b1, b2, t1, t2)
//
// Neighbouring keys may stand at the same point, where a camera rests. Their knots are equal
// then. A mix that would divide by the difference of their knots, 0, returns this point
// instead, so that no NaN comes out. Right within 1e-9 of the largest coordinate.
// [/catmull_rom]
glm::dvec3 catmull_rom(const FourKeys& keys, double t) {
    const auto& [points, knots] = keys;
    const double length = knots[2] - knots[1];
    return length > 0 ? glm::mix(points[1], points[2], (t - knots[1]) / length) : points[1];
}

}  // namespace lightwalk::exercise
