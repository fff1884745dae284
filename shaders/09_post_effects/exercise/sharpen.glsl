// Exercise 09.sharpen: a pixel and its eight neighbours, weighed.
// Until you fill it in, the neighbours count nothing.
#include "09_post_effects/picture_source.glsl"

// [sharpen]
// The pixel filtered by any kernel of 3 by 3: the sum over its rows and columns of kernel[row][column] * texel(neighbour),
// where kernel[0][0] belongs to the neighbour above and to the left, kernel[0][2] to the one above and to the right, and
// kernel[1][1] to the pixel itself; rows run downwards. texel(at) reads one, and is valid inside of the picture alone, from
// ivec2(0) to picture_size() - 1: a neighbour outside stands for the nearest inside. Kernels have weights below 0, pictures
// have no light below 0: that becomes 0.
// [/sharpen]
vec3 sharpen(ivec2 pixel, mat3 kernel) {
    return texel(pixel);
}
