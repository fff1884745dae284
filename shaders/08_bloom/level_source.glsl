// For 08.down_filter: the level above, twice as wide and high.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

// The level above, filtered linearly: `offset` of its texels away from the middle of the texel `at` of this level, which is
// where four of its texels meet.
vec3 above(ivec2 at, vec2 offset) { return read(vec2(2 * at + 1) + offset); }
