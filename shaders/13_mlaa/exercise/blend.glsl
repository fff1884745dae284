// Exercise 13.blend: a pixel mixed with its neighbours across the edges around it.
// Starter: every pixel keeps its own light.

// [blend]
// Returns the light of a pixel mixed with that of its four neighbours. `weights` (x, y,
// z, w) are the weights of the left, right, upper and lower neighbour, each 0 to 1. The
// pixel's own light has the remaining weight, 1 minus their sum. Around a thin line the
// sum may exceed 1: scale the four weights so that they add up to 1, and the own light
// has the weight 0.
//
// Light with a weight of 0 must not influence the result, even if it is infinite or NaN
// (0 times either is NaN); this holds for the neighbours and for the pixel's own light.
// All light with a weight above 0 is finite. No channel of the result lies outside of
// the range of the light that is mixed.
// [/blend]
vec3 blend(vec3 own, vec3 left, vec3 right, vec3 above, vec3 below, vec4 weights) {
    return own;
}
