// right, in its pictures too
float bayer(uvec2 pixel, int bits) {
    const int square[4] = int[](0, 2, 3, 1);
    int i = 0, weight = 1;
    for (int bit = bits - 1; bit >= 0; --bit) {
        uvec2 b = pixel >> uint(bit) & 1u;
        i += weight * square[2u * b.y + b.x];
        weight *= 4;
    }
    return (float(i) + 0.5) / float(weight);
}
