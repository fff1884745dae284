// Exercise 07.to_linear: from a stored texel to numbers that may be averaged.
// Starter: codes are averaged unchanged.

// [srgb_to_linear]
// Converts sRGB codes, 0 to 1, to linear light, 0 to 1, channel by channel:
// code / 12.92 for codes up to 0.04045, and ((code + 0.055) / 1.055)^2.4 above.
// [/srgb_to_linear]
vec3 srgb_to_linear(vec3 code) {
    return code;
}

// [normal_to_linear]
// Converts a texel of a normal map to the vector to be averaged. code.rgb holds a
// direction as 0.5 + 0.5 n, not always at unit length: normalise n. code.a = a holds
// the length of the mean that this texel stands for: the result has the length
// 1 - a * a (in the first level a is 0). If n is zero (code.rgb is 0.5 in all
// channels), the direction is (0, 0, 1).
// [/normal_to_linear]
vec3 normal_to_linear(vec4 code) {
    return code.rgb;
}

// [roughness_to_linear]
// Converts roughness r, 0 to 1, to the quantity that adds up when surfaces are mixed:
// the variance of the microfacet slopes. It is proportional to alpha^2 with
// alpha = r^2. Returns r^4.
// [/roughness_to_linear]
float roughness_to_linear(float r) {
    return r;
}
