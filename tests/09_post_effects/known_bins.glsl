// For the check of 09.histogram_bin: how often each bin was incremented, after the previous counts.
#pragma replaces "09_post_effects/histogram_source.glsl"
#include "09_post_effects/histogram_buffer.glsl"

shared uint own_bins[256];

void add_to_picture(uint bin, uint n) {
    if (bin >= 256u) return;
    atomicAdd(picture_bins[256u + bin], 1u);
    atomicAdd(picture_bins[bin], n);
}
