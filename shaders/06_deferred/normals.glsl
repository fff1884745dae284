// Two directions in one word.
#include "06_deferred/encode_normal.glsl"
#include "06_deferred/decode_normal.glsl"

// [quantise]
// Each number in `bits` bits, 1 to 16, so that -1, 0 and 1 come back exactly: what looks along an axis does.
uint quantise(vec2 code, int bits) {
    int most = (1 << (bits - 1)) - 1;
    ivec2 steps = ivec2(round(clamp(code, -1.0, 1.0) * float(most))) + most;
    return uint(steps.x | steps.y << bits);
}

vec2 dequantise(uint word, int bits) {
    int most = (1 << (bits - 1)) - 1, mask = (1 << bits) - 1;
    ivec2 steps = ivec2(int(word) & mask, int(word >> bits) & mask) - most;
    return max(vec2(steps) / float(most), -1.0);
}
// [/quantise]
