// All levels in one dispatch. Each workgroup makes six levels of a 64×64 tile; the last to finish makes the other six
// (AMD, FidelityFX Single Pass Downsampler, 2020).
#ifndef SUBGROUP_LANES
#define SUBGROUP_LANES 1  // none that shuffle
#endif
// Which levels a dispatch makes: all; six; or the rest, in a second dispatch of one workgroup.
#define ALL 0
#define SIX 1
#define REST 2
#ifndef MAKES
#define MAKES ALL
#endif
#if MIPS_REDUCTION == MIPS_REDUCTION_SHUFFLE || (MIPS_REDUCTION == MIPS_REDUCTION_AUTO && SUBGROUP_LANES >= 32)
#define BY_SHUFFLES 1
#else
#define BY_SHUFFLES 0
#endif
#if BY_SHUFFLES && SUBGROUP_LANES > 1
#extension GL_KHR_shader_subgroup_shuffle : require
#endif
#include "07_mipmaps/source.glsl"
#include "07_mipmaps/box_2x2.glsl"
#include "07_mipmaps/last_workgroup.glsl"

layout(local_size_x = 256) in;

writeonly uniform image2DArray levels[12];
layout(scalar) uniform ChainBlock {
    int made;           // how many levels: 1 to 12
    int first_counter;  // of finished[]: the one of layer 0, which is 0 before the dispatch
} chain;

// Input of the last workgroup: means of 64×64 texels each.
layout(scalar) coherent buffer TileBuffer { vec4 tile_means[]; };
const int tiles_across = 64;

ivec2 size_of(int level) { return max(source_size() >> level, ivec2(1)); }

void keep(int level, ivec2 at, vec4 mean) {
    if (level <= chain.made && all(lessThan(at, size_of(level))))
        imageStore(levels[level - 1], ivec3(at, layer), encode(mean));
}

#include "07_mipmaps/reduce_by_shuffles.glsl"

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

// A texel of level 1, or of level 7. Numbers by one lookup in the middle of four texels, where that is asked for: some
// devices round the weights of a linear filter, and all four count alike only where the size makes the place exact.
vec4 mean_of_source(ivec2 at) {
#if MIPS_BILINEAR && MIPS_CONTENT == MIPS_CONTENT_LINEAR
    if (all(greaterThan(source_size(), ivec2(1))))
        return textureLod(source, vec3((2.0 * vec2(at) + 1.0) / vec2(source_size()), float(layer)), 0.0);
#endif
    return box_2x2(at);
}

vec4 tile_mean(int x, int y) { return tile_means[(layer * tiles_across + y) * tiles_across + x]; }

vec4 mean_of_tiles(ivec2 at) {
    ivec2 a = 2 * at, b = min(a + 1, size_of(6) - 1);
    return 0.25 * (tile_mean(a.x, a.y) + tile_mean(b.x, a.y) + tile_mean(a.x, b.y) + tile_mean(b.x, b.y));
}

// [single_pass]
void main() {
    ivec2 tile = ivec2(gl_WorkGroupID.xy);
    layer = int(gl_WorkGroupID.z);
    vec4 four[4];
    bool last = MAKES == REST;
#if MAKES != REST
    for (int i = 0; i < 4; ++i) four[i] = mean_of_source(min(place(i, tile), size_of(1) - 1));
    vec4 mean = reduce(0, tile, four);
    if (chain.made <= 6) return;
    if (gl_LocalInvocationIndex == 0 && all(lessThan(tile, ivec2(tiles_across))))
        tile_means[(layer * tiles_across + tile.y) * tiles_across + tile.x] = mean;
#endif
#if MAKES == ALL
    last = is_last_workgroup(chain.first_counter + layer, gl_NumWorkGroups.x * gl_NumWorkGroups.y);
#endif
    // A loop that runs once at most: a software rasteriser goes through both sides of an `if`, and leaves a loop.
    while (last) {
        for (int i = 0; i < 4; ++i) four[i] = mean_of_tiles(min(place(i, ivec2(0)), size_of(7) - 1));
        reduce(6, ivec2(0), four);
        last = false;
    }
}
// [/single_pass]
