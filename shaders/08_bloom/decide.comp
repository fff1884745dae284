// Every step's workgroups; or none, where nothing is to be spread.
#include "08_bloom/dispatches.glsl"
layout(local_size_x = 64) in;
layout(scalar) readonly buffer WantedBuffer { uint wanted[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < lit_at()) dispatches[i] = dispatches[lit_at()] * wanted[i];
    if (i == 0u) dispatches[spreads_at()] = dispatches[lit_at()];
}
