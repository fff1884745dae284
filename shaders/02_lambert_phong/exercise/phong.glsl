// Exercise 02.phong: a highlight around the mirror direction.
// Starter: there is no highlight.

// [phong]
// Phong's specular lobe: the cosine of the angle between `to_eye` and the mirror image of
// `to_light` about `normal`, raised to `shininess`. All three directions are unit vectors;
// `shininess` is 0 or more. The result is 0 if the light is behind the surface, and also if
// the cosine is 0 or negative: GLSL leaves pow(0, 0) and pow of a negative number
// undefined.
// [/phong]
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    return 0.0;
}
