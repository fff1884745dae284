// Exercise 02.blinn_phong: a highlight around the half vector, and how bright it must be.
// Until you fill it in, there is no highlight.

// [blinn_phong]
// The cosine between `normal` and the half vector, which points halfway between `to_light` and `to_eye`, to the power
// of `shininess`. All directions have length 1, shininess is 0 or more. It is 0 where the light is behind the surface,
// and where the cosine is not above 0. There is no half vector where the light is right behind the surface's point
// as seen from the eye (to_light = -to_eye): the result is 0 there too, not NaN.
// [/blinn_phong]
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    return 0.0;
}

// [blinn_phong_normalisation]
// What the highlight is multiplied by so that a surface reflects all light and no more when seen from above, whatever
// its shininess n: (n + 2)(n + 4) / (8 (2^(-n/2) + n)). A matt white surface counts as 1 in the same measure.
// [/blinn_phong_normalisation]
float blinn_phong_normalisation(float shininess) {
    return 1.0;
}
