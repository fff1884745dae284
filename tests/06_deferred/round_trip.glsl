// For the check of 06.quantise: a code's way into a word and out of it, with other bits above.
#include "06_deferred/quantise.glsl"

struct CheckRoundTrip {
    vec2 code;
    float beyond;  // how many bits of the word that are not the code's
};

CheckRoundTrip check_round_trip(vec2 code, int bits, int other) {
    uint word = quantise(code, bits), above = bits < 16 ? ~0u << uint(2 * bits) : 0u;
    return CheckRoundTrip(dequantise((word & ~above) | (uint(other) & above), bits), float(bitCount(word & above)));
}
