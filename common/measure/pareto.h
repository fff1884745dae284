// Pareto front of time and error.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace lightwalk {

struct Cost {
    double time = 0, error = 0;
};

/// Indices of the finite points that no other dominates (no worse in both, better in one), in ascending time.
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

/// Index of the fastest point with error <= `budget`; points.size() if there is none.
inline size_t cheapest_within(std::span<const Cost> points, double budget) {
    size_t best = points.size();
    for (size_t i = 0; i < points.size(); ++i)
        if (points[i].error <= budget && std::isfinite(points[i].time) &&
            (best == points.size() || points[i].time < points[best].time))
            best = i;
    return best;
}

}  // namespace lightwalk
