// Exercise 08.down_filter: one texel of a level from the level above.
// Until you fill it in, it is the mean of four texels: a lone bright pixel flickers when it moves.
#include "08_bloom/level_source.glsl"

// [down_filter]
// The texel `at` of a level of half the size. above(at, offset) reads the level above with a linear filter, `offset` of its
// texels away from the middle of `at`, where four of its texels meet: above(at, vec2(0)) is the mean of those four. Wanted
// is a filter that
// - keeps the light: each texel of the level above has weights in this level that add up to 1/4, wherever it lies;
// - moves nothing: the mean position of what a texel gives is the texel's own;
// - takes nothing away: no weight is below 0;
// - blurs by 1.75 square texels in each axis, variance, within 0.05: the whole pyramid counts on it.
// Jimenez's has 13 reads: the mean of four at (+-1, +-1) with half of the weight, and with an eighth each the means of four
// squares of side 2 whose corners lie on the grid of -2, 0 and 2 (a read that two or four squares share is read once).
// [/down_filter]
vec3 down_filter(ivec2 at) {
    return above(at, vec2(0.0));
}
