// right
#include "08_bloom/level_source.glsl"
vec3 down_filter(ivec2 at) {
    vec3 sum = vec3(0.0);
    for (int y = -2; y <= 2; y += 2)
        for (int x = -2; x <= 2; x += 2) {
            sum += float((2 - abs(x) / 2) * (2 - abs(y) / 2)) / 32.0 * above(at, vec2(x, y));
            if (x < 2 && y < 2) sum += 0.125 * above(at, vec2(x, y) + 1.0);
        }
    return sum;
}
