// right, in its pictures too
float bayer(uvec2 pixel, int bits) {
    uint i = 0u;
    for (int bit = 0; bit < bits; ++bit) {
        uint x = pixel.x >> uint(bit) & 1u, y = pixel.y >> uint(bit) & 1u;
        i = i << 2u | (x ^ y) << 1u | x;
    }
    return (float(i) + 0.5) / float(1 << 2 * bits);
}
