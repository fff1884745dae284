// For 08.down_filter: the level above, twice as wide and high.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

#ifdef IMPULSE_X
// For checks: a level that is black but for one texel, which is 1.
float hat(float x) { return max(0.0, 1.0 - abs(x)); }
vec3 above(ivec2 at, vec2 offset) {
    vec2 from_impulse = vec2(2 * at + 1) + offset - (vec2(IMPULSE_X, IMPULSE_Y) + 0.5);
    return vec3(hat(from_impulse.x) * hat(from_impulse.y));
}
#else
// The level above, filtered linearly: `offset` of its texels away from the middle of the texel `at` of this level, which is
// where four of its texels meet.
vec3 above(ivec2 at, vec2 offset) { return read(vec2(2 * at + 1) + offset); }
#endif
