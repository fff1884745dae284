// Exercise 09.radial_blur: a blur towards one point.
// Starter: nothing is blurred.
#include "09_post_effects/picture_source.glsl"

// [radial_blur]
// Returns the mean of `taps` reads of picture(uv) at evenly spaced points of a straight
// line. The first read is at uv itself, the last at uv + strength * (centre - uv); for
// a strength of 1 that is the centre. strength is 0 to 1, taps 1 to 64. For one tap the
// result is picture(uv) alone.
// [/radial_blur]
vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps) {
    return picture(uv);
}
