#include "common/measure/planes.h"

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

// A fixed count of accumulators lets the compiler keep them in vector registers.
constexpr int block = 16;

}  // namespace

Plane filter_rows(const Plane& in, std::span<const float> kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        // One row with its borders repeated, and room for the last block to run over.
        std::vector<float> padded(size_t(in.width + 2 * radius + block));
        for (int y = begin; y < end; ++y) {
            const float* row = in.row(y);
            std::fill_n(padded.begin(), radius, row[0]);
            std::copy_n(row, in.width, padded.begin() + radius);
            std::fill(padded.begin() + radius + in.width, padded.end(), row[in.width - 1]);
            for (int x = 0; x < in.width; x += block) {
                float sum[block] = {};
                for (size_t tap = 0; tap < kernel.size(); ++tap) {
                    const float weight = kernel[tap];
                    const float* from = padded.data() + x + tap;
                    for (int i = 0; i < block; ++i) sum[i] += weight * from[i];
                }
                std::copy_n(sum, std::min(block, in.width - x), out.row(y) + x);
            }
        }
    });
    return out;
}

Plane filter_columns(const Plane& in, std::span<const float> kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(in.width, in.height);
    for_row_bands(in.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            int x = 0;
            for (; x + block <= in.width; x += block) {
                float sum[block] = {};
                for (int tap = 0; tap < static_cast<int>(kernel.size()); ++tap) {
                    const float weight = kernel[size_t(tap)];
                    const float* from = in.row(std::clamp(y + tap - radius, 0, in.height - 1)) + x;
                    for (int i = 0; i < block; ++i) sum[i] += weight * from[i];
                }
                std::copy_n(sum, block, out.row(y) + x);
            }
            for (; x < in.width; ++x) {
                float sum = 0.0f;
                for (int tap = 0; tap < static_cast<int>(kernel.size()); ++tap)
                    sum += kernel[size_t(tap)] * in.row(std::clamp(y + tap - radius, 0, in.height - 1))[x];
                out.row(y)[x] = sum;
            }
        }
    });
    return out;
}

}  // namespace lightwalk
