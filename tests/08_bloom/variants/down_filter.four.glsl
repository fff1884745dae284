// wrong: blurred with a variance
#include "08_bloom/level_source.glsl"
vec3 down_filter(ivec2 at) {
    return 0.25 * (above(at, vec2(-1.0, -1.0)) + above(at, vec2(1.0, -1.0)) + above(at, vec2(-1.0, 1.0)) + above(at, vec2(1.0, 1.0)));
}
