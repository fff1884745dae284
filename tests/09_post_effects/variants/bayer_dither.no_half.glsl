// wrong: bayer(
float bayer(uvec2 pixel, int bits) {
    uint i = 0u;
    for (int bit = 0; bit < bits; ++bit) {
        uint x = pixel.x >> uint(bit) & 1u, y = pixel.y >> uint(bit) & 1u;
        i = 4u * i + 2u * (x ^ y) + y;
    }
    return float(i) / float(1 << 2 * bits);
}
