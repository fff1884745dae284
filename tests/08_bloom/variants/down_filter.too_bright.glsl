// wrong: of its light to this level
#include "08_bloom/level_source.glsl"
vec3 down_filter(ivec2 at) {
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += 0.125 * above(at, 1.5 * vec2(x, y));
    return sum;
}
