// Exercise 07.to_linear: from what a texel holds to numbers whose mean means something.
// Until you fill it in, codes are averaged as they are.

// [srgb_to_linear]
// sRGB codes, 0 to 1, to linear light, 0 to 1: code / 12.92 up to 0.04045, above ((code + 0.055) / 1.055)^2.4.
// [/srgb_to_linear]
vec3 srgb_to_linear(vec3 code) {
    return code;
}

// [normal_to_linear]
// A normal map's texel to the mean of the normals that it stands for, a vector no longer than 1. x, y and z of its
// direction are coded as 0.5 + 0.5 n, not always at unit length; its length is 1 - a * a (in the first level a is 0).
// Where the code has no direction (all 0.5), it is (0, 0, 1).
// [/normal_to_linear]
vec3 normal_to_linear(vec4 code) {
    return code.rgb;
}

// [roughness_to_linear]
// What of roughness r, 0 to 1, is additive: the variance of the microfacets' slopes, which is r^4. (alpha is r^2, and
// the variance is proportional to alpha^2.)
// [/roughness_to_linear]
float roughness_to_linear(float r) {
    return r;
}
