// For 09.histogram_bin: where a workgroup counts, and where the picture does.
#include "09_post_effects/histogram_buffer.glsl"

shared uint own_bins[256];

void add_to_picture(uint bin, uint n) {
#ifdef COUNTED
    // For checks: how often each bin was added to, behind what was added.
    if (bin >= 256u) return;
    atomicAdd(picture_bins[256u + bin], 1u);
#endif
#ifndef NO_PICTURE
    atomicAdd(picture_bins[bin], n);
#endif
}
