// Exercise 09.tone_curve: Hill's fit of the ACES tone curve.
// Starter: light above 1 is clipped.
#include "09_post_effects/hill_matrices.glsl"

// [tone_curve]
// Maps radiance, 0 to 65504 in each channel, to display values, 0 to 1. S. Hill's fit
// has three steps. The matrix hill_input converts the colour to a space with wider
// primaries (hill_input * color); hill_output converts it back. In between, each
// channel v becomes
//
//     (v (v + 0.0245786) - 0.000090537) / (v (0.983729 v + 0.4329510) + 0.238081)
//
// The fit alone is not a safe tone curve. Evaluate it for black, for very bright light,
// and for bright light of a single colour. The next effect takes a power of the result,
// and the screen shows 0 to 1: decide where in the chain the values have to be limited,
// and to which range.
// [/tone_curve]
vec3 tone_curve(vec3 radiance) {
    return min(radiance, 1.0);
}
