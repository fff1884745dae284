// Exercise 09.exposure_gamma: how bright a picture is, in two ways that are not the same.
// Until you fill it in, nothing changes.

// [exposure_gamma]
// expose: the radiance as a camera would take it whose shutter is open 2^stops times as long. A stop is a factor of two:
// stops of -1 give half of the light, 0 gives all of it. stops is -16 to 16. Radiance stays linear.
//
// apply_gamma: each channel of a colour to the power of 1 / gamma, so that a gamma above 1 brightens what lies between 0 and
// 1, and 0 and 1 themselves stay. Light below 0 counts as 0. A knob can stand anywhere: where gamma is 0 or less there is no
// such power, and the colour is returned as it came.
// [/exposure_gamma]
vec3 expose(vec3 radiance, float stops) {
    return radiance;
}

vec3 apply_gamma(vec3 color, float gamma) {
    return color;
}
