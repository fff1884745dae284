// For 09.histogram_bin: where a workgroup counts, and where the picture does.
#include "09_post_effects/histogram_buffer.glsl"

shared uint own_bins[256];

void add_to_picture(uint bin, uint n) { atomicAdd(picture_bins[bin], n); }
