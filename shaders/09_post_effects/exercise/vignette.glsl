// Exercise 09.vignette: a picture that darkens towards its corners.
// Starter: it does not darken.

// [vignette]
// Returns the factor of the pixel at uv (0 to 1 over the picture):
// 1 - strength * r^power. r is the distance from the middle of the picture divided by
// the distance of a corner. Measure both distances in pixels, not in uv, so that lines
// of equal brightness are circles: the picture is `aspect` times as wide as high.
// strength is 0 to 1, power 0 to 8. For a power of 0, r^power is 1 everywhere, also in
// the very middle (pow(0, 0) is undefined in GLSL).
// [/vignette]
float vignette(vec2 uv, float aspect, float strength, float power) {
    return 1.0;
}
