// wrong: thread
#include "08_bloom/line_source.glsl"
vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex);
    for (int slot = own; slot < threads + 2 * radius; slot += threads) keep_texel(slot, texel(start - radius + slot));
    vec3 sum = vec3(0.0);
    for (int k = -radius; k <= radius; ++k) sum += weight_at(abs(k)) * kept_texel(own + radius + k);
    return sum;
}
