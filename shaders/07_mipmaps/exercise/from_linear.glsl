// Exercise 07.from_linear: the way back, from a mean to the stored texel.
// Starter: means are stored unchanged.

// [linear_to_srgb]
// Converts linear light c to sRGB codes, channel by channel: 12.92 c for c up to
// 0.0031308, and 1.055 c^(1/2.4) - 0.055 above. A filter with negative weights gives
// values outside 0 to 1; clamp them to that range first.
// [/linear_to_srgb]
vec3 linear_to_srgb(vec3 linear) {
    return linear;
}

// [normal_from_linear]
// Converts a mean of normals to a texel. rgb is 0.5 + 0.5 n, where n is the direction
// of the mean at unit length. alpha is sqrt(1 - length(mean)), and 0 for a mean longer
// than 1. If the normals cancel (a length below 0.0001), n is (0, 0, 1), and alpha is
// the same root as always.
// [/normal_from_linear]
vec4 normal_from_linear(vec3 mean) {
    return vec4(mean, 1.0);
}

// [roughness_from_linear]
// Converts a mean of r^4 to the roughness r, 0 or more. Treat a mean below 0 as 0.
// [/roughness_from_linear]
float roughness_from_linear(float mean) {
    return mean;
}
