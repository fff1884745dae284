// Filtering for FLIP: planes of floats, separable kernels, borders repeated, rows spread over threads.
#pragma once
#include <functional>
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

/// 1-D weights, 2r + 1 of them, and their sum: 1 for a blur, 0 for a derivative.
struct Kernel {
    std::vector<float> weights;
    float sum = 1.0f;
};

/// out(x, y) = sum of weights[r + i] * in(x + i, y), i in [-r, r], with the border value repeated outside. Computed
/// as sum * in(x, y) plus weighted differences from in(x, y): a constant stays exactly constant, and its derivative
/// is exactly 0 (FLIP takes its square root). The order of additions is fixed, so the result does not depend on the
/// number of threads.
Plane filter_rows(const Plane& in, const Kernel& kernel);
/// The same along y.
Plane filter_columns(const Plane& in, const Kernel& kernel);

}  // namespace lightwalk
