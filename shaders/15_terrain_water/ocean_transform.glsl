// Inverse Fourier transforms of four lines in shared memory by a workgroup of 256 threads.
layout(local_size_x = 256) in;
#include "15_terrain_water/fourier_lines.glsl"

void transform() {
    uint own = gl_LocalInvocationIndex;
    if (own < OCEAN_TEXELS / 2u) {
        float angle = 6.2831853 * float(own) / float(OCEAN_TEXELS);
        turns[own] = vec2(cos(angle), sin(angle));
    }
    fourier_lines(own);
}
