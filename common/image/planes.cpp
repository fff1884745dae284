#include "common/image/planes.h"

#include <algorithm>
#include <thread>

namespace lightwalk {

void for_row_bands(int height, const std::function<void(int, int)>& work) {
    const int cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    const int bands = std::min(cores, std::max(1, height / 16));
    std::vector<std::jthread> others;
    for (int band = 1; band < bands; ++band)
        others.emplace_back([&, band] { work(height * band / bands, height * (band + 1) / bands); });
    work(0, height / bands);
}

namespace {

// Accumulators per block: a constant number stays in vector registers.
constexpr int block = 16;

}  // namespace

Plane filter_rows(const Plane& in, const Kernel& kernel) {
    const int taps = static_cast<int>(kernel.weights.size()), radius = taps / 2;
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        std::vector<float> padded(size_t(in.width + 2 * radius + block));
        for (int y = begin; y < end; ++y) {
            const float* row = in.row(y);
            std::fill_n(padded.begin(), radius, row[0]);
            std::copy_n(row, in.width, padded.begin() + radius);
            std::fill(padded.begin() + radius + in.width, padded.end(), row[in.width - 1]);
            for (int x = 0; x < in.width; x += block) {
                const float* centre = padded.data() + x + radius;
                float total[block];
                for (int i = 0; i < block; ++i) total[i] = kernel.sum * centre[i];
                for (int tap = 0; tap < taps; ++tap) {
                    const float weight = kernel.weights[size_t(tap)];
                    const float* from = centre + tap - radius;
                    for (int i = 0; i < block; ++i) total[i] += weight * (from[i] - centre[i]);
                }
                std::copy_n(total, std::min(block, in.width - x), out.row(y) + x);
            }
        }
    });
    return out;
}

Plane filter_columns(const Plane& in, const Kernel& kernel) {
    const int taps = static_cast<int>(kernel.weights.size()), radius = taps / 2;
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float* centre = in.row(y);
            float* to = out.row(y);
            for (int x = 0; x < in.width; ++x) to[x] = kernel.sum * centre[x];
            for (int tap = 0; tap < taps; ++tap) {
                const float weight = kernel.weights[size_t(tap)];
                const float* from = in.row(std::clamp(y + tap - radius, 0, in.height - 1));
                for (int x = 0; x < in.width; ++x) to[x] += weight * (from[x] - centre[x]);
            }
        }
    });
    return out;
}

}  // namespace lightwalk
