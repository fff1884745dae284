// For the check of 08.down_filter: a level that is black but for one texel, which is 1.
#pragma replaces "08_bloom/level_source.glsl"

float check_hat(float x) { return max(0.0, 1.0 - abs(x)); }

vec3 above(ivec2 at, vec2 offset) {
    vec2 from_impulse = vec2(2 * at + 1) + offset - (vec2(IMPULSE_X, IMPULSE_Y) + 0.5);
    return vec3(check_hat(from_impulse.x) * check_hat(from_impulse.y));
}
