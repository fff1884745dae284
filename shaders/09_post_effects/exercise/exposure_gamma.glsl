// Exercise 09.exposure_gamma: how bright a picture is, in two ways that are not the same.
// Until you fill it in, nothing changes.

// [exposure_gamma]
// expose: the radiance as if the shutter were open 2^stops times as long; stops is -16 to 16. Radiance stays linear.
//
// apply_gamma: each channel to the power of 1 / gamma, so that a gamma above 1 brightens what lies between 0 and 1. Light below 0
// counts as 0. A knob can stand anywhere: where gamma is 0 or less there is no such power, and the colour is returned as it came.
// [/exposure_gamma]
vec3 expose(vec3 radiance, float stops) {
    return radiance;
}

vec3 apply_gamma(vec3 color, float gamma) {
    return color;
}
