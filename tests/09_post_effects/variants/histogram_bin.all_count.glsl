// wrong: count_together
#include "09_post_effects/histogram_source.glsl"
uint histogram_bin(float luminance) {
    if (!(luminance >= 1.0 / 4096.0)) return 0u;
    return 1u + uint(min((log2(min(luminance, 4096.0)) + 12.0) * 255.0 / 24.0, 254.0));
}
void count_together(uint bin, bool counts) {
    own_bins[gl_LocalInvocationIndex] = 0u;
    barrier();
    atomicAdd(own_bins[bin], 1u);
    barrier();
    if (own_bins[gl_LocalInvocationIndex] > 0u) add_to_picture(gl_LocalInvocationIndex, own_bins[gl_LocalInvocationIndex]);
}
