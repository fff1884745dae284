// wrong: called turned() 1024 times
// All terms of each sum.
#include "15_terrain_water/ocean_line.glsl"

void fourier_lines(uint thread) {
    barrier();
    vec4 sums[4];
    for (uint i = 0u; i < 4u; ++i) {
        sums[i] = vec4(0.0);
        for (uint k = 0u; k < 256u; ++k) {
            uint by = k * thread & 255u;
            sums[i] += by < 128u ? turned(line[256u * i + k], by) : -turned(line[256u * i + k], by - 128u);
        }
    }
    barrier();
    for (uint i = 0u; i < 4u; ++i) line[256u * i + thread] = sums[i];
    barrier();
}
