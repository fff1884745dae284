// Solution of 08.blur_line.
#include "08_bloom/line_source.glsl"

vec3 blur_line(int start, int radius) {
    int own = int(gl_LocalInvocationIndex);
    for (int slot = own; slot < threads + 2 * radius; slot += threads) keep_texel(slot, texel(start - radius + slot));
    barrier();  // all texels are loaded
    int middle = own + radius;
    vec3 sum = weight_at(0) * kept_texel(middle);
    for (int k = 1; k <= radius; ++k) sum += weight_at(k) * (kept_texel(middle - k) + kept_texel(middle + k));
    return sum;
}
