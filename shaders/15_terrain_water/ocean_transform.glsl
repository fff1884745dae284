// Inverse Fourier transforms of four lines of 256 texels in shared memory, two complex fields each. T. Stockham's order
// (1966), which needs no bits reversed.
layout(local_size_x = 256) in;

shared vec4 line[4 * OCEAN_TEXELS];  // 16 KiB
shared vec2 turns[OCEAN_TEXELS / 2u];

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec4 turned(vec4 two, uint by) { return vec4(times(two.xy, turns[by]), times(two.zw, turns[by])); }

// Two of the eight steps at a time, of the strides s and 2 s: each of a line's 64 threads keeps four texels in registers.
void transform() {
    uint own = gl_LocalInvocationIndex;
    if (own < OCEAN_TEXELS / 2u) {
        float angle = 6.2831853 * float(own) / float(OCEAN_TEXELS);
        turns[own] = vec2(cos(angle), sin(angle));
    }
    uint first = own / 64u * OCEAN_TEXELS, j = own % 64u;
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
