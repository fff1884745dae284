// [minimal]
// Morphological antialiasing (A. Reshetov, HPG 2009): smooths stairs along edges by mixing pixels as a straight
// silhouette would. The pictures are half planes with known exact pixels.
#include <cmath>
#include <cstdio>
#include <vector>

constexpr int side = 96;              // pixels
using Picture = std::vector<double>;  // grey levels in linear light, row by row

// Smooths all edges along rows, or along columns, from a picture with stairs into a copy of it.
void smooth(const Picture& from, Picture& to, bool columns) {
    const auto index = [&](int x, int y) { return size_t(columns ? x * side + y : y * side + x); };
    const auto step = [&](int x, int y, int x2, int y2) { return from[index(x, y)] - from[index(x2, y2)]; };
    for (int y = 0; y + 1 < side; ++y)
        for (int first = 0, end; first < side; first = end) {
            // 1. A line: neighbouring pixels that differ from those below. It ends where two shapes touch at a corner.
            const auto below = [&](int x) { return std::fabs(step(x, y, x, y + 1)) > 0.1; };
            const auto beside = [&](int x, int row) {
                return x > 0 && x < side && std::fabs(step(x - 1, row, x, row)) > 0.1;
            };
            // Where the edge turns between x - 1 and x: into the row below (1), into the row above (-1), or not at all.
            const auto turn = [&](int x) { return beside(x, y + 1) - beside(x, y); };
            end = first + 1;
            if (!below(first)) continue;
            while (end < side && below(end) && !(beside(end, y) && beside(end, y + 1))) ++end;
            // 2. The silhouette: from half a pixel off the line at an end where it turns, to the line in its middle.
            for (int x = first; x < end; ++x) {
                const double t = 2 * (x + 0.5 - first) / (end - first) - 1;  // -1 to 1 along the line
                const double under = 0.5 * std::fabs(t) * (t < 0 ? turn(first) : turn(end));
                // 3. The pixel that the silhouette crosses takes that share of its neighbour across the line.
                to[index(x, under > 0 ? y + 1 : y)] += under * step(x, y, x, y + 1);
            }
        }
}

int main() {
    double stairs = 0, smoothed = 0, count = 0;
    for (int degrees = 3; degrees < 90; degrees += 4) {
        const double nx = std::sin(degrees * 0.01745329), ny = std::cos(degrees * 0.01745329);
        // The share of n x n points of a pixel within the half plane; a rasteriser takes n = 1.
        const auto share = [&](int i, int n) {
            int inside = 0;
            for (int k = 0; k < n * n; ++k)
                inside += nx * (i % side - 48 + (k % n + 0.5) / n) + ny * (i / side - 48 + (k / n + 0.5) / n) < 0.3;
            return double(inside) / (n * n);
        };
        Picture picture(side * side), result;
        for (int i = 0; i < side * side; ++i) picture[i] = share(i, 1);
        result = picture;
        smooth(picture, result, false), smooth(picture, result, true);
        for (int i = 0; i < side * side; ++i) {
            const double exact = share(i, 16);
            if (exact == 0 || exact == 1 || i % side < 24 || i % side > 71 || i / side < 24 || i / side > 71) continue;
            stairs += std::pow(picture[i] - exact, 2), smoothed += std::pow(result[i] - exact, 2), ++count;
        }
    }
    std::printf("stairs %.4f\nsmoothed %.4f\n", std::sqrt(stairs / count), std::sqrt(smoothed / count));
}
// [/minimal]
