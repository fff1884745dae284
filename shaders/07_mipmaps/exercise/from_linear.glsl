// Exercise 07.from_linear: the way back, from a mean to what a texel holds.
// Until you fill it in, means are stored as they are.

// [linear_to_srgb]
// Linear light to sRGB codes: 12.92 c up to 0.0031308, above 1.055 c^(1/2.4) - 0.055. A filter with negative weights
// gives means outside of 0 to 1: those are clamped first.
// [/linear_to_srgb]
vec3 linear_to_srgb(vec3 linear) {
    return linear;
}

// [normal_from_linear]
// A mean of normals to a texel: its direction, at unit length, as 0.5 + 0.5 n, and in alpha the root of what the mean's
// length lacks to 1; a mean longer than 1 lacks nothing. Where normals cancel (a length below 0.0001) the direction is
// (0, 0, 1), and alpha is still the root.
// [/normal_from_linear]
vec4 normal_from_linear(vec3 mean) {
    return vec4(mean, 1.0);
}

// [roughness_from_linear]
// A mean of r^4 to a roughness. A mean below 0 is 0.
// [/roughness_from_linear]
float roughness_from_linear(float mean) {
    return mean;
}
