#include <algorithm>
#include <cmath>

#include "17_planets/exercises.h"

namespace lightwalk::solution {
namespace {

// The mean over a box of 2 r + 1 texels by a running sum; `at(i)` is the i-th number's place after wrap or clamp.
template <class Place>
void blur_line(const float* from, float* to, int count, size_t stride, int r, const Place& at) {
    double sum = 0;
    for (int i = -r; i <= r; ++i) sum += static_cast<double>(from[at(i) * stride]);
    const double share = 1.0 / (2 * r + 1);
    for (int i = 0; i < count; ++i) {
        to[static_cast<size_t>(i) * stride] = static_cast<float>(sum * share);
        sum += static_cast<double>(from[at(i + r + 1) * stride]) - static_cast<double>(from[at(i - r) * stride]);
    }
}

std::vector<float> blurred(const std::vector<float>& map, int width, int height, int r) {
    std::vector<float> rows(map.size()), all(map.size());
    const size_t w = static_cast<size_t>(width);
    const auto wrapped = [&](int i) { return static_cast<size_t>(((i % width) + width) % width); };
    const auto clamped = [&](int i) { return static_cast<size_t>(std::clamp(i, 0, height - 1)); };
    for (size_t y = 0; y < static_cast<size_t>(height); ++y) blur_line(&map[y * w], &rows[y * w], width, 1, r, wrapped);
    for (size_t x = 0; x < w; ++x) blur_line(&rows[x], &all[x], height, w, r, clamped);
    return all;
}

void add_octave(std::vector<float>& heights, const std::vector<float>& fine, const std::vector<float>& coarse,
                float size) {
    double sum = 0, squares = 0;
    for (size_t i = 0; i < fine.size(); ++i) {
        const double x = static_cast<double>(fine[i] - coarse[i]);
        sum += x;
        squares += x * x;
    }
    const double n = static_cast<double>(fine.size()), mean = sum / n;
    const double deviation = std::sqrt(std::max(squares / n - mean * mean, 0.0));
    if (deviation < 1e-9) return;
    const float scale = size / static_cast<float>(deviation);
    for (size_t i = 0; i < fine.size(); ++i) heights[i] += scale * (fine[i] - coarse[i]);
}

}  // namespace

std::vector<glm::vec3> overlay_normals(int width, int height, std::span<const float> brightness, int octaves,
                                       float slope) {
    std::vector<float> fine(brightness.begin(), brightness.end()), heights(fine.size(), 0.0f);
    const std::vector<float> map = fine;
    for (int i = 0; i < octaves; ++i) {
        std::vector<float> coarse = blurred(map, width, height, 1 << i);
        add_octave(heights, fine, coarse, static_cast<float>(1 << i));
        fine = std::move(coarse);
    }
    std::vector<glm::vec3> normals(fine.size());
    const float scale = 0.5f * slope / static_cast<float>(octaves);
    const auto at = [&](int x, int y) {
        return heights[static_cast<size_t>(std::clamp(y, 0, height - 1)) * static_cast<size_t>(width) +
                       static_cast<size_t>((x + width) % width)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float dx = at(x + 1, y) - at(x - 1, y), dy = at(x, y - 1) - at(x, y + 1);
            normals[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
                glm::normalize(glm::vec3(-scale * dx, -scale * dy, 1.0f));
        }
    return normals;
}

}  // namespace lightwalk::solution
