// Exercise 08.down_filter: one texel of a level from the level above.
// Starter: it is the mean of four texels: a lone bright pixel flickers when it moves.
#include "08_bloom/level_source.glsl"

// [down_filter]
// Returns the texel `at` of a level of half the size. above(at, offset) reads the level
// above with a linear filter. `offset` is measured in texels of the level above, from
// the centre of `at`, where four of its texels meet: above(at, vec2(0)) is the mean of
// those four.
//
// The filter has to meet four conditions:
// - It preserves light: the weights that one texel of the level above has in all texels
//   of this level add up to 1/4, wherever that texel lies.
// - It moves nothing: the mean position of those weights is the position of the texel.
// - No weight is negative.
// - Its variance is 1.75 square texels of the level above along each axis, within 0.05:
//   the width of the whole pyramid is computed from it.
//
// One solution is Jimenez's filter with 13 reads. Half of the weight belongs to the
// mean of the four reads at (+-1, +-1). The other half is shared by four squares, with
// an eighth of the total weight each. The value of a square is the mean of the reads at
// its four corners. The squares have a side of 2, and their corners lie at -2, 0 and 2
// along each axis. A read that several squares share is done once, with the sum of its
// weights.
// [/down_filter]
vec3 down_filter(ivec2 at) {
    return above(at, vec2(0.0));
}
