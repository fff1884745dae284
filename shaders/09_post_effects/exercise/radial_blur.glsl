// Exercise 09.radial_blur: the rush towards one point.
// Until you fill it in, everything stands still.
#include "09_post_effects/picture_source.glsl"

// [radial_blur]
// The mean of `taps` reads of picture(uv), which are evenly spaced on a straight line: the first at uv itself, the last at
// uv + strength * (centre - uv), so that at a strength of 1 it would be the centre. strength is 0 to 1, taps 1 to 64. Where
// taps is 1 there is no last one: picture(uv) alone.
// [/radial_blur]
vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps) {
    return picture(uv);
}
