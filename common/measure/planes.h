// Filtering for FLIP: planes of floats, separable kernels, borders repeated, rows spread over threads.
#pragma once
#include <functional>
#include <span>
#include <vector>

namespace lightwalk {

/// One channel of an image.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int wide, int high) : width(wide), height(high), values(size_t(wide) * size_t(high)) {}
    float* row(int y) { return values.data() + size_t(y) * size_t(width); }
    const float* row(int y) const { return values.data() + size_t(y) * size_t(width); }
};

/// Calls work(y_begin, y_end) over [0, height) from as many threads as there are cores, at most 8.
void for_row_bands(int height, const std::function<void(int, int)>& work);

/// out(x, y) = sum of kernel[r + i] * in(x + i, y), i in [-r, r], kernel.size() = 2r + 1; beyond the border the
/// border's value repeats. The sum's order is fixed, so that the result does not depend on the number of threads.
Plane filter_rows(const Plane& in, std::span<const float> kernel);
/// The same along y.
Plane filter_columns(const Plane& in, std::span<const float> kernel);

}  // namespace lightwalk
