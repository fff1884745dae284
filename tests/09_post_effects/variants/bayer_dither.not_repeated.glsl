// wrong: bayer(
float bayer(uvec2 pixel, int bits) {
    const int square[4] = int[](0, 2, 3, 1);
    if (bits != 2) return 0.5;
    int i = 4 * square[(2u * pixel.y + pixel.x) & 3u] + square[(pixel.y / 2u * 2u + pixel.x / 2u) & 3u];
    return (float(i) + 0.5) / 16.0;
}
