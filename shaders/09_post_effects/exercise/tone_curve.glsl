// Exercise 09.tone_curve: Hill's fit of the film-like curve of ACES.
// Until you fill it in, what is above 1 is cut off.
#include "09_post_effects/hill_matrices.glsl"

// [tone_curve]
// From light, 0 to 65504 in each channel, to what a screen shows, 0 to 1. S. Hill's fit has three steps. hill_input * radiance
// brings the colour into a space with wider primaries. There each channel v becomes
//     (v (v + 0.0245786) - 0.000090537) / (v (0.983729 v + 0.4329510) + 0.238081)
// and hill_output * that brings it back. Look at the ends. What comes out for black? Somebody will take a power of it. And is
// everything between 0 and 1 for light that is bright, or of one colour alone?
// [/tone_curve]
vec3 tone_curve(vec3 radiance) {
    return min(radiance, 1.0);
}
