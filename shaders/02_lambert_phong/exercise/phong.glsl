// Exercise 02.phong: a highlight around the mirror direction.
// Until you fill it in, there is no highlight.

// [phong]
// The cosine between `to_eye` and the mirror image of `to_light` about `normal`, to the power of `shininess`. All three
// directions have length 1, shininess is 0 or more. It is 0 where the light is behind the surface, and where the cosine
// is not above 0: pow(0, 0) is not defined in GLSL, nor is pow of a negative number.
// [/phong]
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    return 0.0;
}
