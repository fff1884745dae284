// right
#include "08_bloom/line_source.glsl"
vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex);
    int all = threads + 2 * radius, each = (all + threads - 1) / threads;
    for (int i = 0; i < each; ++i) {
        int slot = own * each + i;
        if (slot < all) keep_texel(slot, texel(start - radius + slot));
    }
    memoryBarrierShared();
    barrier();
    vec3 sum = vec3(0.0);
    for (int k = -radius; k <= radius; ++k) sum += weight_at(abs(k)) * kept_texel(own + radius + k);
    return sum;
}
