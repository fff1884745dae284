#include <cmath>

#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

// E. T. Y. Lee, "Choosing nodes in parametric curve interpolation", Computer-Aided Design 21, 1989.
std::vector<double> centripetal_knots(const std::vector<glm::dvec3>& points) {
    std::vector<double> knots;
    for (size_t i = 0; i < points.size(); ++i)
        knots.push_back(i == 0 ? 0.0 : knots[i - 1] + std::sqrt(glm::distance(points[i - 1], points[i])));
    return knots;
}

}  // namespace lightwalk::solution
