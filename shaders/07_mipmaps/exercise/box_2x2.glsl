// Exercise 07.box_2x2: one texel of a level from four texels of the level above it.
// Starter: one texel of four is used and three are discarded: the level flickers as much as no level at
// all.
#include "07_mipmaps/source.glsl"

// [box_2x2]
// Returns the mean of the 2×2 texels of the level above that are covered by the texel
// `at` of this level: (2x, 2y) to (2x + 1, 2y + 1) for at = (x, y). texel(p) reads one
// texel of the level above as numbers that may be averaged (linear light, for
// instance). p must lie inside, from (0, 0) to source_size() - 1. If a side of the
// level above is one texel long, the mean is that of two texels, or of one. If a side
// is odd and longer than 1, the last column or row is not covered by any texel: that is
// a weakness of this filter, not an error of yours.
// [/box_2x2]
vec4 box_2x2(ivec2 at) {
    return texel(min(2 * at, source_size() - 1));
}
