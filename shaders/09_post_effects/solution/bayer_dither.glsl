// Solution of 09.bayer_dither. B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", 1973.
float bayer(uvec2 pixel, int bits) {
    uint i = 0u;
    for (int bit = 0; bit < bits; ++bit) {
        uint x = pixel.x >> uint(bit) & 1u, y = pixel.y >> uint(bit) & 1u;
        i = 4u * i + 2u * (x ^ y) + y;  // the lowest bits of x and y weigh most
    }
    return (float(i) + 0.5) / float(1u << uint(2 * bits));
}
