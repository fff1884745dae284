// right
#include "08_bloom/level_source.glsl"
vec3 down_filter(ivec2 at) {
    const float places[] = float[](-1.75, 0.0, 1.75), weights[] = float[](0.25, 0.5, 0.25);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) sum += weights[x] * weights[y] * above(at, vec2(places[x], places[y]));
    return sum;
}
