// Exercise 07.box_2x2: one texel of a level from those of the level above it.
// Until you fill it in, one texel of four is taken and three are thrown away: a level that flickers as none at all does.
#include "07_mipmaps/source.glsl"

// [box_2x2]
// The mean of the two by two texels of the level above that the texel `at` covers: texel(p) reads one, in linear light.
// p must lie inside: from (0, 0) to source_size() - 1. A side of that level may be one texel long; then the mean is of
// two texels, or of one. Of a side that is odd and longer, the last column or row is left over: that is this filter's
// weakness and not yours.
// [/box_2x2]
vec4 box_2x2(ivec2 at) {
    return texel(min(2 * at, source_size() - 1));
}
