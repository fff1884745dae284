// Moments of depth, and visibility from them. Depth: 0 at the near plane, 1 at the far plane.
#include "05_shadow_maps/chebyshev.glsl"

// Warp of exponential variance shadow maps (A. Lauritzen and M. McCool, "Layered Variance Shadow Maps", GI 2008): e^cz
// compresses depths in front of the receiver, -e^-cz those behind. The square of e^c must fit the format: ln(3.4e38) /
// 2 is 44.3, ln(65504) / 2 is 5.54, less a margin for sums.
float exponent_cap() {
#if SHADOW_FORMAT == SHADOW_FORMAT_FP16
    return 5.54;
#else
    return 42.0;
#endif
}
vec2 warp(float depth, float exponent, float exponent_negative) {
    float z = 2.0 * depth - 1.0;
    return vec2(exp(min(exponent, exponent_cap()) * z), -exp(-min(exponent_negative, exponent_cap()) * z));
}

vec4 moments_of(float depth, float exponent, float exponent_negative) {
#if SHADOW_METHOD == SHADOW_METHOD_EVSM
    vec2 w = warp(depth, exponent, exponent_negative);
    return vec4(w, w * w);
#else
    float square = depth * depth;
    return vec4(depth, square, square * depth, square * square);
#endif
}

float evsm(vec4 moments, float depth, float exponent, float exponent_negative, float least) {
    vec2 w = warp(depth, exponent, exponent_negative);
    // Slope of the warp, which scales a depth variance of `least`.
    vec2 scale = 2.0 * vec2(min(exponent, exponent_cap()), min(exponent_negative, exponent_cap())) * w;
    vec2 deviation = sqrt(least) * scale;  // squared afterwards: scale * scale alone may overflow
    vec2 smallest = max(deviation * deviation, 1e-30);
    return min(chebyshev(moments.xz, w.x, smallest.x), chebyshev(moments.yw, w.y, smallest.y));
}

// Moment shadow mapping (C. Peters and R. Klein, I3D 2015): among depth distributions with these four moments, the one
// with the least mass in front of the receiver has three depths, one of them the receiver's. The others are roots of a
// quadratic whose coefficients c solve B c = (1, z, z²), with B the Hankel matrix of the moments.
float msm(vec4 moments, float z, float bias) {
    vec4 b = mix(moments, vec4(0.5), bias);  // keeps B invertible despite rounding
    // Factorisation B = L D Lᵀ, L with unit diagonal; B's first column is (1, b.x, b.y).
    float d2 = max(b.y - b.x * b.x, 1e-12), l32 = (b.z - b.x * b.y) / d2;
    float d3 = max(b.w - b.y * b.y - l32 * l32 * d2, 1e-12);
    float y2 = z - b.x, y3 = z * z - b.y - l32 * y2;
    float c3 = y3 / d3, c2 = y2 / d2 - l32 * c3, c1 = 1.0 - b.x * c2 - b.y * c3;
    float most = max(abs(c3), 1e-12) * (c3 < 0.0 ? -1.0 : 1.0);
    float half_p = -0.5 * c2 / most, root = sqrt(max(half_p * half_p - c1 / most, 0.0));
    float z1 = half_p - root, z2 = half_p + root;
    if (z <= z1) return 1.0;
    // Mass in front of the receiver.
    float a = z <= z2 ? z : z1, in_front = z <= z2 ? 0.0 : 1.0, other = z <= z2 ? z1 : z;
    float apart = (z2 - other) * (z - z1);
    if (abs(apart) < 1e-20) return 1.0 - in_front;
    float share = (a * z2 - b.x * (a + z2) + b.y) / apart;
    return clamp(1.0 - (in_front + share), 0.0, 1.0);
}
