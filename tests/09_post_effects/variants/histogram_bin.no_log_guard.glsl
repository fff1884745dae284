// wrong: log
#include "09_post_effects/histogram_source.glsl"
uint histogram_bin(float luminance) {
    float stops = log2(luminance) + 12.0;
    return stops >= 0.0 ? 1u + uint(min(stops * 255.0 / 24.0, 254.0)) : 0u;
}
void count_together(uint bin, bool counts) {
    own_bins[gl_LocalInvocationIndex] = 0u;
    barrier();
    if (counts) atomicAdd(own_bins[bin], 1u);
    barrier();
    if (own_bins[gl_LocalInvocationIndex] > 0u) add_to_picture(gl_LocalInvocationIndex, own_bins[gl_LocalInvocationIndex]);
}
