#include <algorithm>

#include "13_mlaa/exercises.h"

namespace lightwalk::solution {

// A trapezium, or, where the outline ends within the pixel, a triangle: its width by the mean of its heights.
float area(int position, int length) {
    const float middle = 0.5f * static_cast<float>(length), start = static_cast<float>(position);
    if (length == 1 || start >= middle) return 0.0f;
    const float end = std::min(start + 1.0f, middle);
    const auto height = [&](float x) { return 0.5f * (1.0f - x / middle); };
    return 0.5f * (end - start) * (height(start) + height(end));
}

}  // namespace lightwalk::solution
