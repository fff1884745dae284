// right
#include "08_bloom/line_source.glsl"
vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex), all = threads + 2 * radius;
    for (int first = 0; first < all; first += threads) {
        int slot = first + own;
        if (slot < all) keep_texel(slot, texel(start - radius + slot));
        memoryBarrierShared();
        barrier();
    }
    int middle = own + radius;
    vec3 sum = weight_at(0) * kept_texel(middle);
    for (int k = 1; k <= radius; ++k) sum += weight_at(k) * (kept_texel(middle - k) + kept_texel(middle + k));
    return sum;
}
