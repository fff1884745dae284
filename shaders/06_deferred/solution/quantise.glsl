// Solution of 06.quantise.

uint quantise(vec2 code, int bits) {
    int most = (1 << (bits - 1)) - 1;
    ivec2 steps = ivec2(round(clamp(code, -1.0, 1.0) * float(most))) + most;  // 0 to 2 most, which `bits` bits hold
    return uint(steps.x | steps.y << bits);
}

vec2 dequantise(uint word, int bits) {
    int most = (1 << (bits - 1)) - 1, mask = (1 << bits) - 1;
    ivec2 steps = ivec2(int(word) & mask, int(word >> bits) & mask) - most;
    return max(vec2(steps) / float(most), -1.0);
}
