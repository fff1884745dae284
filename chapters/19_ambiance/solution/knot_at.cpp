#include <algorithm>

#include "19_ambiance/exercises.h"

namespace lightwalk::solution {

// The slopes of M. Steffen, "A simple method for monotonic interpolation in one dimension", Astronomy and Astrophysics 239,
// 1990, for values that never fall.
double knot_at(const std::vector<double>& times_s, const std::vector<double>& knots, double time_s) {
    if (!(time_s > times_s.front())) return knots.front();
    if (time_s >= times_s.back()) return knots.back();
    size_t i = 0;
    while (time_s >= times_s[i + 1]) ++i;
    const auto h = [&](size_t k) { return times_s[k + 1] - times_s[k]; };
    const auto d = [&](size_t k) { return (knots[k + 1] - knots[k]) / h(k); };
    const auto slope = [&](size_t k) {
        if (k == 0) return d(0);
        if (k + 1 == knots.size()) return d(k - 1);
        return std::min({2 * d(k - 1), 2 * d(k), (d(k - 1) * h(k) + d(k) * h(k - 1)) / (h(k - 1) + h(k))});
    };
    const double u = (time_s - times_s[i]) / h(i), v = 1 - u;
    return knots[i] * v * v * (1 + 2 * u) + knots[i + 1] * u * u * (1 + 2 * v) +
           h(i) * u * v * (slope(i) * v - slope(i + 1) * u);
}

}  // namespace lightwalk::solution
