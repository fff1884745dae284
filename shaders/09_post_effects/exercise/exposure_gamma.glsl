// Exercise 09.exposure_gamma: two ways of changing the brightness of a picture.
// Starter: nothing changes.

// [exposure_gamma]
// expose: returns the radiance as if the shutter were open 2^stops times as long. stops
// is -16 to 16. Radiance stays linear.
//
// apply_gamma: returns each channel raised to the power 1 / gamma, so that a gamma
// above 1 brightens values between 0 and 1. A channel below 0 counts as 0 (pow of a
// negative number is undefined in GLSL). The knob may have any value: if gamma is 0 or
// less, there is no such power, and the colour is returned unchanged.
// [/exposure_gamma]
vec3 expose(vec3 radiance, float stops) {
    return radiance;
}

vec3 apply_gamma(vec3 color, float gamma) {
    return color;
}
