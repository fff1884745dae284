// Exercise 19.centripetal_knots: when a curve passes its keys.
// Starter: the knots are evenly spaced, and the curve loops and overshoots where keys stand close together.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [centripetal_knots]
// The knots of a centripetal Catmull-Rom curve through `points` (any number of them): the first
// is 0, and from one to the next they rise by the square root of the distance between their
// points. Equal points have the same knot. A result for each point. Right within
// 1e-9 of the last knot.
// [/centripetal_knots]
std::vector<double> centripetal_knots(const std::vector<glm::dvec3>& points) {
    std::vector<double> knots;
    for (size_t i = 0; i < points.size(); ++i) knots.push_back(double(i));
    return knots;
}

}  // namespace lightwalk::exercise
