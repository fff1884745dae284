// Pareto front of time and error.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace lightwalk {

/// One way: both the smaller the better, in any unit.
struct Cost {
    double time = 0, error = 0;
};

/// Indices of the points that no other point dominates, by rising time. A point dominates another when it is no worse
/// in both and better in one; so equal points stand or fall together. A point with NaN or infinity is never on it.
inline std::vector<size_t> pareto_front(std::span<const Cost> points) {
    std::vector<size_t> order;
    for (size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].time) && std::isfinite(points[i].error)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) {
        return points[i].time != points[j].time ? points[i].time < points[j].time : points[i].error < points[j].error;
    });
    std::vector<size_t> front;
    for (const size_t i : order) {
        const bool first = front.empty();
        const Cost& last = points[first ? i : front.back()];
        const bool equal = points[i].time == last.time && points[i].error == last.error;
        if (first || equal || points[i].error < last.error) front.push_back(i);
    }
    return front;
}

/// The cheapest point with an error of at most `budget`; points.size() if there is none.
inline size_t cheapest_within(std::span<const Cost> points, double budget) {
    size_t best = points.size();
    for (size_t i = 0; i < points.size(); ++i)
        if (points[i].error <= budget && std::isfinite(points[i].time) &&
            (best == points.size() || points[i].time < points[best].time))
            best = i;
    return best;
}

}  // namespace lightwalk
