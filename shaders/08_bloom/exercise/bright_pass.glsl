// Exercise 08.bright_pass: the light of a pixel that is blurred.
// Starter: all light is blurred, and one infinite or NaN pixel spoils the picture.
#include "common/light.glsl"
#include "08_bloom/soft_knee.glsl"

// [bright_pass]
// Returns the radiance scaled so that its luminance becomes
// soft_knee(luminance(radiance), threshold, knee); the colour stays the same. A picture
// may contain infinity and NaN: replace the radiance by finite_light(radiance) before
// any other calculation. Black stays black: its luminance is 0 and must not divide
// anything.
// [/bright_pass]
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    return radiance;
}
