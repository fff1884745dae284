// Exercise 09.contrast_saturation: contrast around middle grey, and saturation around luminance.
// Starter: nothing changes.
#include "common/light.glsl"

// [contrast_saturation]
// contrast: each channel c, in linear light, becomes 0.18 (c / 0.18)^amount, so that
// middle grey, 0.18, stays and nothing falls below 0. A channel below 0 counts as 0.
// amount is 0 to 4. For an amount of 0 every channel becomes 0.18, also a black one
// (pow(0, 0) is undefined in GLSL).
//
// saturate_color: returns grey + amount * (color - grey), where grey has the luminance
// of the colour in all channels; luminance(color) is available. amount is 0 to 4: 0
// gives grey, 1 the colour itself, more exaggerates it. A channel below 0 becomes 0.
// [/contrast_saturation]
vec3 contrast(vec3 color, float amount) {
    return color;
}

vec3 saturate_color(vec3 color, float amount) {
    return color;
}
