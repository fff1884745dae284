// Six levels of a tile by one workgroup of 256 threads, through shared memory: on any device.
#if !BY_SHUFFLES

shared vec4 means[16][16];

ivec2 own() { return ivec2(gl_LocalInvocationIndex % 16u, gl_LocalInvocationIndex / 16u); }

// Where the i-th of this thread's four texels of the first level is.
ivec2 place(int i, ivec2 tile) { return 2 * (16 * tile + own()) + ivec2(i & 1, i >> 1); }

// [reduce]
// Six levels of a 64×64 tile of level `from`; `four`: this thread's texels of the first. The first thread gets the last
// texel.
vec4 reduce(int from, ivec2 tile, vec4 four[4]) {
    // Two levels in registers: four texels of the first, one of the second.
    for (int i = 0; i < 4; ++i) keep(from + 1, place(i, tile), four[i]);
    vec4 mean = 0.25 * (four[0] + four[1] + four[2] + four[3]);
    keep(from + 2, 16 * tile + own(), mean);
    means[own().y][own().x] = mean;

    // Four levels in shared memory, from 16×16 to 1×1. A side of one texel stays one.
    int index = int(gl_LocalInvocationIndex);
    for (int level = from + 3, side = 8; side > 0; ++level, side /= 2) {
        barrier();  // writes before reads
        ivec2 p = ivec2(index % side, index / side), a = 2 * p;
        ivec2 b = min(a + 1, max(size_of(level - 1) - 1 - 2 * side * tile, ivec2(0)));
        bool mine = index < side * side;
        if (mine) mean = 0.25 * (means[a.y][a.x] + means[a.y][b.x] + means[b.y][a.x] + means[b.y][b.x]);
        barrier();  // reads before writes
        if (mine) {
            means[p.y][p.x] = mean;
            keep(level, side * tile + p, mean);
        }
    }
    return mean;
}
// [/reduce]
#endif
