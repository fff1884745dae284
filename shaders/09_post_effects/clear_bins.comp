// Before anything is counted.
#include "09_post_effects/histogram_buffer.glsl"
layout(local_size_x = 256) in;
void main() { picture_bins[gl_GlobalInvocationID.x] = 0u; }
