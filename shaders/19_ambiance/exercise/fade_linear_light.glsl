// Exercise 19.fade_linear_light: a picture that goes dark, or white, as light does.
// Starter: the film never fades: each scene ends at full brightness.

// [fade_linear_light]
// Fades a pixel to black and to white. `light` is its linear light, 0 or more in each channel,
// before any tone curve: a lamp may have 1, the sun 1,000. `black` and `white` say how far the
// picture has faded; values outside 0 to 1 are clamped to this range.
//
// 1. To black: multiply the light by (1 - black) to the power of 2.2. The codes on a screen
//    then fall about evenly with time. All channels have the same factor, so colours stay, and
//    anything far brighter than white stays white nearly to the end.
// 2. To white, from the result of step 1: each channel c below 16 becomes c + f (16 - c), where
//    f is `white` to the power of 2.2. Every tone curve of chapter 09 shows 16 as white.
//    Channels above 16 stay as they are.
//
// With black and white 0 nothing changes; black 1 gives exactly 0, white 1 at least 16 in each
// channel. The result must be right within 1e-5 of its value.
// [/fade_linear_light]
vec3 fade_linear_light(vec3 light, float black, float white) {
    return light;
}
