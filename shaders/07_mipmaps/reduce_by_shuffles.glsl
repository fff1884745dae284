// Six levels of a tile by one workgroup of 256 threads, by subgroup shuffles in groups of 32 and one barrier. Values from
// beyond a smaller subgroup go through shared memory and barriers: slow, for tests.
#if BY_SHUFFLES

shared vec4 means[4][4];

#if SUBGROUP_LANES >= 32
vec4 from_lane(vec4 value, int bit) { return subgroupShuffleXor(value, 1u << bit); }
#else
shared vec4 lanes[256];
vec4 from_lane(vec4 value, int bit) {
#if SUBGROUP_LANES > 1
    if (1 << bit < SUBGROUP_LANES) return subgroupShuffleXor(value, 1u << bit);
#endif
    barrier();
    lanes[gl_LocalInvocationIndex] = value;
    barrier();
    return lanes[gl_LocalInvocationIndex ^ 1u << bit];
}
#endif

// Bits of a thread's number: 0, 2, 4 and 5 count columns, 1, 3, 6 and 7 rows. The 32 threads of a group store a
// block of 8×4 texels in each of the first two levels.
int bit(int n) { return int(gl_LocalInvocationIndex >> n) & 1; }
ivec2 region() { return ivec2(bit(5), int(gl_LocalInvocationIndex >> 6)); }  // 16×8 texels of the first level

// Where the i-th of this thread's four texels of the first level is.
ivec2 place(int i, ivec2 tile) {
    ivec2 block = 2 * region() + ivec2(i & 1, i >> 1);
    return 32 * tile + ivec2(8, 4) * block + ivec2(bit(0) + 2 * bit(2) + 4 * bit(4), bit(1) + 2 * bit(3));
}

// [exchange]
// Four threads that differ in bits 0 and 1 each hold one texel of four 2×2 blocks. Each gets the mean of one block by
// exchanging with its neighbour in x, then in y.
vec4 exchange(vec4 four[4]) {
    bool right = bit(0) == 1, low = bit(1) == 1;
    vec4 upper = (right ? four[1] : four[0]) + from_lane(right ? four[0] : four[1], 0);
    vec4 lower = (right ? four[3] : four[2]) + from_lane(right ? four[2] : four[3], 0);
    return 0.25 * ((low ? lower : upper) + from_lane(low ? upper : lower, 1));
}

// Mean of the texels of four threads that differ in the bits `x` and `y`. A side of one texel stays one.
vec4 fold(vec4 mean, int x, int y, int level) {
    bvec2 one = equal(size_of(level), ivec2(1));
    vec4 other = from_lane(mean, x);
    mean += one.x ? mean : other;
    other = from_lane(mean, y);
    return 0.25 * (mean + (one.y ? mean : other));
}
// [/exchange]

// Six levels of a 64×64 tile of level `from`; `four`: this thread's texels of the first. The first thread gets the last
// texel.
vec4 reduce(int from, ivec2 tile, vec4 four[4]) {
    uint n = gl_LocalInvocationIndex;
    for (int i = 0; i < 4; ++i) keep(from + 1, place(i, tile), four[i]);
    if (chain.made <= from + 1) return four[0];
    vec4 mean = exchange(four);
    ivec2 block = 2 * region() + ivec2(bit(0), bit(1));
    keep(from + 2, 16 * tile + ivec2(4, 2) * block + ivec2(bit(2) + 2 * bit(4), bit(3)), mean);
    if (chain.made <= from + 2) return mean;
    mean = fold(mean, 2, 3, from + 2);
    if ((n & 12u) == 0u) keep(from + 3, 8 * tile + ivec2(2, 1) * block + ivec2(bit(4), 0), mean);
    if (chain.made <= from + 3) return mean;
    mean = fold(mean, 4, 1, from + 3);
    if ((n & 30u) == 0u) {
        keep(from + 4, 4 * tile + ivec2(2 * region().x + bit(0), region().y), mean);
        means[region().y][2 * region().x + bit(0)] = mean;
    }
    barrier();  // the one: 4×4 texels are left, which every 32 threads read
    mean = fold(means[bit(1) + 2 * bit(3)][bit(0) + 2 * bit(2)], 0, 1, from + 4);
    if ((n & 243u) == 0u) keep(from + 5, 2 * tile + ivec2(bit(2), bit(3)), mean);
    mean = fold(mean, 2, 3, from + 5);
    if (n == 0u) keep(from + 6, tile, mean);
    return mean;
}
#endif
