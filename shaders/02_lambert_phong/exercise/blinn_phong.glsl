// Exercise 02.blinn_phong: a highlight around the half vector, and the factor that keeps its energy constant.
// Starter: there is no highlight.

// [blinn_phong]
// Blinn's specular lobe: the cosine of the angle between `normal` and the half vector,
// raised to `shininess`. The half vector is the unit vector halfway between `to_light` and
// `to_eye`. All directions are unit vectors; `shininess` is 0 or more. The result is 0 if
// the light is behind the surface, and also if the cosine is 0 or negative. If the light is
// directly opposite the eye (to_light = -to_eye) there is no half vector: the result is 0
// then too, not NaN.
// [/blinn_phong]
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    return 0.0;
}

// [blinn_phong_normalisation]
// The normalisation factor of the lobe: (n + 2)(n + 4) / (8 (2^(-n/2) + n)) for the
// exponent n = `shininess`. With it, a white surface seen along its normal reflects exactly
// the light it receives, whatever the exponent. The formula contains no pi because lights
// are given as irradiance / pi.
// [/blinn_phong_normalisation]
float blinn_phong_normalisation(float shininess) {
    return 1.0;
}
