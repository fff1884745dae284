// wrong: barriers
#include "09_post_effects/histogram_source.glsl"

uint histogram_bin(float luminance) {
    if (!(luminance >= 1.0 / 4096.0)) return 0u;  // NaN is not, either
    float stops = log2(min(luminance, 4096.0)) + 12.0;
    return 1u + uint(min(stops * (255.0 / 24.0), 254.0));
}

void count_together(uint bin, bool counts) {
    uint own = gl_LocalInvocationIndex;
    own_bins[own] = 0u;
    barrier();
    if (counts) { atomicAdd(own_bins[bin], 1u); barrier(); }
    barrier();
    if (own_bins[own] != 0u) add_to_picture(own, own_bins[own]);
}
