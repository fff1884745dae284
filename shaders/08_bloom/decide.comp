// Every step's workgroups; or none, where nothing is to be spread.
#include "08_bloom/dispatches.glsl"
layout(local_size_x = 64) in;
layout(scalar) readonly buffer WantedBuffer { uint wanted[]; };
layout(scalar) uniform FrameNowBlock { uint frame_now; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    uint lit = dispatches[lit_at()] == frame_now ? 1u : 0u;
    if (i < lit_at()) dispatches[i] = lit * wanted[i];
    if (i == 0u) dispatches[spreads_at()] = lit;
}
