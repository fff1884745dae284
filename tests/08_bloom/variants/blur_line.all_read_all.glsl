// wrong: times, expected once
#include "08_bloom/line_source.glsl"
vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex);
    vec3 sum = vec3(0.0);
    for (int k = -radius; k <= radius; ++k) sum += weight_at(abs(k)) * texel(start + own + k);
    return sum;
}
