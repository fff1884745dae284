// Solution of 15.fourier_lines, in T. Stockham's order (1966), which needs no bits reversed.
#include "15_terrain_water/ocean_line.glsl"

// Two of the eight steps at a time, of the strides s and 2 s: each of a line's 64 threads keeps four texels in registers.
void fourier_lines(uint thread) {
    uint first = thread / 64u * 256u, j = thread % 64u;
    for (uint bits = 0u; bits < 8u; bits += 2u) {
        uint s = 1u << bits, sp = j & ~(s - 1u), to = first + (j & (s - 1u)) + 4u * sp;
        barrier();  // writes before reads
        vec4 a = line[first + j], b = line[first + j + 64u], c = line[first + j + 128u], d = line[first + j + 192u];
        vec4 sum_ac = a + c, sum_bd = b + d, turned_ac = turned(a - c, sp), turned_bd = turned(b - d, sp + 64u);
        barrier();  // reads before writes
        line[to] = sum_ac + sum_bd;
        line[to + s] = turned_ac + turned_bd;
        line[to + 2u * s] = turned(sum_ac - sum_bd, 2u * sp);
        line[to + 3u * s] = turned(turned_ac - turned_bd, 2u * sp);
    }
    barrier();
}
