// [minimal]
// Mipmaps: a checker on a floor that reaches far away, with and without levels, against the mean of the texture over
// each pixel. Grey levels in linear light: a stored sRGB texture is decoded first.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

// A square texture, `side` a power of two, that repeats. Bilinear: the four nearest texels, weighted by distance.
struct Level {
    int side;
    std::vector<double> texels;
    double texel(double x, double y) const {
        return texels[size_t((int(y) & (side - 1)) * side + (int(x) & (side - 1)))];
    }
    double at(double u, double v) const {
        const double x = std::floor(u * side - 0.5), y = std::floor(v * side - 0.5), f = u * side - 0.5 - x;
        const double upper = (1 - f) * texel(x, y) + f * texel(x + 1, y);
        return upper + (v * side - 0.5 - y) * ((1 - f) * texel(x, y + 1) + f * texel(x + 1, y + 1) - upper);
    }
};

int main() {
    // 1. The levels: each texel is the mean of the four that it covers, down to a single one.
    std::vector<Level> levels{{64, std::vector<double>(64 * 64)}};
    for (int i = 0; i < 64 * 64; ++i) levels[0].texels[i] = (i / 8 + i / 64 / 8) % 2;  // 8x8 squares
    while (levels.back().side > 1) {
        const Level fine = levels.back();
        Level coarse{fine.side / 2, {}};
        for (int y = 0; y < fine.side; y += 2)
            for (int x = 0; x < fine.side; x += 2)
                coarse.texels.push_back(
                    (fine.texel(x, y) + fine.texel(x + 1, y) + fine.texel(x, y + 1) + fine.texel(x + 1, y + 1)) / 4);
        levels.push_back(coarse);
    }
    // 2. The level: a pixel that covers n texels needs level log2(n); between two levels both are mixed.
    const auto sample = [&](double u, double v, double footprint) {  // footprint: of the pixel, in texture widths
        const double level = std::clamp(std::log2(footprint * 64), 0.0, double(levels.size() - 1));
        const size_t lower = size_t(level), upper = std::min(lower + 1, levels.size() - 1);
        return std::lerp(levels[lower].at(u, v), levels[upper].at(u, v), level - double(lower));
    };
    // 3. The floor, 160 x 120 pixels; u and v are its texture coordinates at a place of the picture.
    const auto u_at = [](double x, double y) { return 0.9 * (x - 80) / (y + 1); };
    const auto v_at = [](double y) { return 40 / (y + 1); };
    double without = 0, with = 0;
    for (int i = 0; i < 160 * 120; ++i) {
        const double x = i % 160, y = i / 160;
        double exact = 0;
        for (int k = 0; k < 32 * 32; ++k) {
            const double sub_y = y + (k / 32 + 0.5) / 32;
            exact += levels[0].at(u_at(x + (k % 32 + 0.5) / 32, sub_y), v_at(sub_y)) / (32 * 32);
        }
        const double u = u_at(x + 0.5, y + 0.5), v = v_at(y + 0.5);  // and the longer step to a neighbouring pixel:
        const double below = std::hypot(u_at(x + 0.5, y + 1.5) - u, v_at(y + 1.5) - v);
        const double found = sample(u, v, std::max(u_at(x + 1.5, y + 0.5) - u, below));
        without += std::pow(levels[0].at(u, v) - exact, 2), with += std::pow(found - exact, 2);
    }
    std::printf("without %.4f\nwith %.4f\n", std::sqrt(without / 19200), std::sqrt(with / 19200));
}
// [/minimal]
