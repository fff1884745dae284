// Exercise 06.quantise: find the fault in the packing of an octahedral code.
// Starter: floors and walls that face exactly along +x or +y are lit as if they faced the opposite direction.

// [quantise]
// quantise() stores the two numbers of an octahedral code, -1 to 1 or by rounding a little
// outside, in the lowest 2 * bits bits of a word, and 0 in all bits above them: another code is
// put there. `bits` is 2 to 16. dequantise() takes them out again; the bits above may then hold
// anything. What comes out is within half a step of what went in, a step being
// 2 / (2^bits - 2), and -1, 0 and 1 come back exactly. Both hold to 1e-6.
//
// The functions below have one fault, which one line of each repeats. Find it by its symptom,
// and mend it.
// [/quantise]
uint quantise(vec2 code, int bits) {
    int most = 1 << (bits - 1);
    ivec2 steps = ivec2(round(clamp(code, -1.0, 1.0) * float(most))) + most;
    return uint(steps.x | steps.y << bits);
}

vec2 dequantise(uint word, int bits) {
    int most = 1 << (bits - 1), mask = (1 << bits) - 1;
    ivec2 steps = ivec2(int(word) & mask, int(word >> bits) & mask) - most;
    return max(vec2(steps) / float(most), -1.0);
}
