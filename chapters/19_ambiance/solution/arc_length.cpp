#include <algorithm>

#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

double arc_length(const std::vector<glm::dvec3>& points, double share) {
    std::vector<double> covered(points.size());  // at each point
    for (size_t i = 1; i < points.size(); ++i) covered[i] = covered[i - 1] + glm::distance(points[i - 1], points[i]);
    if (!(share > 0)) return 0;
    if (share >= 1) return 1;
    const double all = covered.back(), wanted = share * all;
    if (all <= 0) return share;
    const auto after = std::lower_bound(covered.begin() + 1, covered.end(), wanted);
    const auto i = std::min(static_cast<size_t>(after - covered.begin()), points.size() - 1);
    const double within = (wanted - covered[i - 1]) / (covered[i] - covered[i - 1]);
    return (double(i - 1) + std::clamp(within, 0.0, 1.0)) / double(points.size() - 1);
}

}  // namespace lightwalk::solution
