// Separable filtering of float planes, for FLIP. Borders are replicated; rows are distributed over threads.
#pragma once
#include <functional>
#include <vector>

namespace lightwalk {

struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int wide, int high) : width(wide), height(high), values(size_t(wide) * size_t(high)) {}
    float* row(int y) { return values.data() + size_t(y) * size_t(width); }
    const float* row(int y) const { return values.data() + size_t(y) * size_t(width); }
};

/// Calls work(y_begin, y_end) over [0, height) on up to 8 threads, at most one per core.
void for_row_bands(int height, const std::function<void(int, int)>& work);

/// 2r + 1 weights and their sum: 1 for a blur, 0 for a derivative.
struct Kernel {
    std::vector<float> weights;
    float sum = 1.0f;
};

/// out(x, y) = Σ weights[r + i] · in(x + i, y), i in [-r, r], borders replicated. Computed as sum · in(x, y) plus
/// weighted differences from in(x, y), so that constants stay exact and their derivative is exactly 0 (FLIP takes its
/// square root). Additions have a fixed order, independent of the number of threads.
Plane filter_rows(const Plane& in, const Kernel& kernel);
Plane filter_columns(const Plane& in, const Kernel& kernel);

}  // namespace lightwalk
