// Exercise 13.blend: a pixel takes its share of light from across the edges around it.
// Until you fill it in, it keeps its own.

// [blend]
// `weights` are the shares (each 0 to 1) that the light on the left, right, above and below has in this pixel; what they
// leave is the pixel's own. Around a thin line they may add up to more than 1: then they are scaled to add up to 1, and
// nothing of the own is left. A neighbour whose share is 0 does not count, whatever it is: it may be infinite or NaN, and
// so may the own light where nothing is left of it. All others are finite. No result is outside of what is mixed.
// [/blend]
vec3 blend(vec3 own, vec3 left, vec3 right, vec3 above, vec3 below, vec4 weights) {
    return own;
}
