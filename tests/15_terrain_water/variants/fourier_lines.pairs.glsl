// right, in its pictures too
// A step at a time: two pairs each, half a line apart, in Stockham's order.
#include "15_terrain_water/ocean_line.glsl"

void fourier_lines(uint thread) {
    for (uint s = 1u; s < 256u; s *= 2u) {
        vec4 sums[2], differences[2];
        uint to[2];
        barrier();
        for (uint i = 0u; i < 2u; ++i) {
            uint pair = thread + 256u * i, base = pair / 128u * 256u, j = pair % 128u, sp = j & ~(s - 1u);
            vec4 a = line[base + j], b = line[base + j + 128u];
            sums[i] = a + b;
            differences[i] = turned(a - b, sp);
            to[i] = base + j + sp;
        }
        barrier();
        for (uint i = 0u; i < 2u; ++i) {
            line[to[i]] = sums[i];
            line[to[i] + s] = differences[i];
        }
    }
    barrier();
}
