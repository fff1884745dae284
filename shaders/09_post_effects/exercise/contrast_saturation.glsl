// Exercise 09.contrast_saturation: how far apart a picture's brightnesses are, and its colours.
// Until you fill it in, nothing changes.
#include "common/light.glsl"

// [contrast_saturation]
// contrast: each channel c, in linear light, becomes 0.18 (c / 0.18)^amount. Middle grey, 0.18, stays, and nothing goes below 0: a
// straight line would cut the shadows off. Light below 0 counts as 0. amount is 0 to 4. At 0 every channel is 0.18, also one that
// was black.
//
// saturate_color: the colour moved away from the grey of its own luminance (amount above 1) or towards it (below 1; at 0 it is that
// grey). amount is 0 to 4. No channel goes below 0. luminance(color) is at hand.
// [/contrast_saturation]
vec3 contrast(vec3 color, float amount) {
    return color;
}

vec3 saturate_color(vec3 color, float amount) {
    return color;
}
