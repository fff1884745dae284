// wrong: thread
#include "08_bloom/line_source.glsl"
vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex);
    keep_texel(own, texel(start - radius + own));
    if (own < 2 * radius) keep_texel(own + threads, texel(start - radius + own + threads));
    barrier();
    vec3 sum = vec3(0.0);
    for (int k = -radius; k <= radius; ++k) sum += weight_at(abs(k)) * kept_texel(own + radius + k);
    return sum;
}
