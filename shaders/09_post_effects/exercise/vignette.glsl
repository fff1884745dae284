// Exercise 09.vignette: a picture that is darker towards its corners.
// Until you fill it in, it is not.

// [vignette]
// By what the pixel at uv (0 to 1 over the picture) is multiplied: 1 - strength * r^power. r is the distance from the picture's
// middle over that of a corner, both in pixels, not in uv: the picture is `aspect` times as wide as it is high, and the rings are
// round. strength is 0 to 1, power 0 to 8. At a power of 0 every pixel is darkened alike, also the one in the very middle.
// [/vignette]
float vignette(vec2 uv, float aspect, float strength, float power) {
    return 1.0;
}
