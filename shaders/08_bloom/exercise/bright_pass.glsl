// Exercise 08.bright_pass: what of a pixel is spread over its neighbours.
// Until you fill it in, everything is, and one broken pixel breaks the picture.
#include "common/light.glsl"
#include "08_bloom/soft_knee.glsl"

// [bright_pass]
// The radiance, scaled so that its luminance becomes soft_knee(luminance(radiance), threshold, knee): its colour stays. A
// picture holds anything: take finite_light(radiance) in place of the radiance from the start, so that no infinity and no
// NaN is spread. Black stays black: there is no luminance to divide by.
// [/bright_pass]
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    return radiance;
}
