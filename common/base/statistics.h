// Percentiles: robust summaries of times and errors with outliers.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <span>
#include <vector>

namespace lightwalk {

/// Percentile of ascending, finite values at `share` in [0, 1], by linear interpolation at rank share (n - 1): Hyndman
/// and Fan's type 7, as numpy. NaN if empty.
template <class Values>
double percentile_of_sorted(const Values& ascending, double share) {
    if (ascending.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double rank = std::clamp(share, 0.0, 1.0) * static_cast<double>(ascending.size() - 1);
    const size_t below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, ascending.size() - 1);
    const double low = static_cast<double>(ascending[below]), high = static_cast<double>(ascending[above]);
    // Avoids infinity - infinity.
    return low == high ? low : low + (rank - static_cast<double>(below)) * (high - low);
}

template <class Values>
std::vector<std::ranges::range_value_t<Values>> sorted_numbers(const Values& values) {
    std::vector<std::ranges::range_value_t<Values>> sorted;
    for (const auto value : values)
        if (!(value != value)) sorted.push_back(value);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

template <class Values>
double percentile(const Values& values, double share) {
    return percentile_of_sorted(sorted_numbers(values), share);
}

template <class Values>
double median(const Values& values) {
    return percentile(values, 0.5);
}

struct Quartiles {
    double q1 = 0, median = 0, q3 = 0;
};

template <class Values>
Quartiles quartiles(const Values& values) {
    const auto sorted = sorted_numbers(values);
    return {percentile_of_sorted(sorted, 0.25), percentile_of_sorted(sorted, 0.5), percentile_of_sorted(sorted, 0.75)};
}

}  // namespace lightwalk
