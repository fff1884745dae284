// Exercise 19.fade_linear_light: a picture that goes dark, or white, as light does.
// As it stands the film never fades: each scene ends at full brightness.

// [fade_linear_light]
// `light` is linear light of one pixel, 0 or more in each channel, before any tone curve: a lamp has 1, a sun 1,000.
// `black` and `white` (0 to 1, clamped here) say how far the picture has faded. Returns the light of the faded picture.
//
// 1. To black: light times (1 - black) to the power of 2.2. Codes on a screen then fall about evenly with time, and since
//    all channels have one factor, colours stay; what is far brighter than white stays so nearly to the end.
// 2. To white, of what step 1 gives: the part white to the power of 2.2 of the way to 16 in each channel, which every tone
//    curve of chapter 09 shows as white. Channels that are brighter than 16 stay as they are.
//
// 0 and 0 change nothing, black 1 is exactly 0, white 1 at least 16. Right within 1e-5 of the value.
// [/fade_linear_light]
vec3 fade_linear_light(vec3 light, float black, float white) {
    return light;
}
