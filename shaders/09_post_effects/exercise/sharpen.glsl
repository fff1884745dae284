// Exercise 09.sharpen: a kernel of 3 by 3 pixels.
// Starter: the neighbours have no weight.
#include "09_post_effects/picture_source.glsl"

// [sharpen]
// Returns the pixel filtered by a 3×3 kernel: the sum over rows and columns of
// kernel[row][column] * texel(neighbour). Rows run downwards, so kernel[0][0] belongs
// to the neighbour above and to the left, kernel[0][2] to the one above and to the
// right, and kernel[1][1] to the pixel itself. The kernel need not be symmetric.
//
// texel(at) reads one pixel. It is valid only inside of the picture, from ivec2(0) to
// picture_size() - 1: use the nearest pixel inside instead of a neighbour outside. A
// kernel may have negative weights, but light is not negative: a channel below 0
// becomes 0.
// [/sharpen]
vec3 sharpen(ivec2 pixel, mat3 kernel) {
    return texel(pixel);
}
