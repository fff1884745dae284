// The transform along z, and all levels of both images. Each workgroup takes four columns of a layer and makes their first
// three levels; the layer's last one to finish makes the other five.
#include "15_terrain_water/water_data.h"
#include "15_terrain_water/ocean_transform.glsl"
#include "07_mipmaps/last_workgroup.glsl"

layout(rgba32f) readonly uniform image2DArray fields;
layout(rgba16f) writeonly uniform image2DArray moved[OCEAN_LEVELS];
layout(rgba16f) writeonly uniform image2DArray sloped[OCEAN_LEVELS];
// Level 2 of each layer, for the workgroup that goes on.
layout(scalar) coherent buffer OceanTilesBuffer { vec4 ocean_tiles[]; };
const uint tiles_across = OCEAN_TEXELS / 4u;

uint layer;  // three of one image, then three of the other

// Stored without the bits that a half float lacks, so that each level is the mean of the one before it: 13, and below 2^-14
// all that are no multiple of 2^-24.
vec4 put(int level, uvec2 at, vec4 value) {
    vec4 kept = uintBitsToFloat(floatBitsToUint(value) & 0xffffe000u);
    kept = mix(kept, trunc(value * exp2(24.0)) * exp2(-24.0), lessThan(abs(value), vec4(exp2(-14.0))));
    if (layer < 3u)
        imageStore(moved[level], ivec3(at, layer), kept);
    else
        imageStore(sloped[level], ivec3(at, layer - 3u), kept);
    return kept;
}

// One level of the texels in shared memory, where they lie column by column. `columns` and 2^`bits` rows are written.
void halve(int level, uvec2 first, uint columns, uint bits) {
    uint own = gl_LocalInvocationIndex, rows = 1u << bits;
    uvec2 at = uvec2(own >> bits, own & (rows - 1u));
    bool mine = at.x < columns;
    vec4 mean = vec4(0.0);
    for (uint i = 0u; mine && i < 4u; ++i)
        mean += 0.25 * line[(2u * at.x + i % 2u) * 2u * rows + 2u * at.y + i / 2u];
    barrier();  // reads before writes
    if (mine) line[own] = put(level, first + at, mean);
    barrier();
}

// Level 3 by all 256 threads from the level 2 of all workgroups, then the rest in shared memory.
void finish() {
    const uint side = tiles_across / 2u;
    for (uint texel = gl_LocalInvocationIndex; texel < side * side; texel += 256u) {
        uvec2 at = uvec2(texel % side, texel / side);
        vec4 mean = vec4(0.0);
        for (uint i = 0u; i < 4u; ++i)
            mean += 0.25 * ocean_tiles[(layer * tiles_across + 2u * at.y + i / 2u) * tiles_across + 2u * at.x + i % 2u];
        line[at.x * side + at.y] = put(3, at, mean);
    }
    barrier();
    for (int level = 4; level < int(OCEAN_LEVELS); ++level) halve(level, uvec2(0), OCEAN_TEXELS >> level, 8u - uint(level));
}

void main() {
    uint own = gl_LocalInvocationIndex, column = own % 4u;
    uvec2 first = uvec2(4u * gl_WorkGroupID.x, 0u);
    layer = gl_WorkGroupID.y;
    for (uint row = own / 4u; row < OCEAN_TEXELS; row += 64u)
        line[column * OCEAN_TEXELS + row] = imageLoad(fields, ivec3(first.x + column, row, layer));
    transform();
    for (uint row = own / 4u; row < OCEAN_TEXELS; row += 64u) {
        uint texel = column * OCEAN_TEXELS + row;
        line[texel] = put(0, uvec2(first.x + column, row), line[texel]);
    }
    barrier();
    halve(1, first / 2u, 2u, 7u);
    halve(2, first / 4u, 1u, 6u);
    if (own < tiles_across) ocean_tiles[(layer * tiles_across + own) * tiles_across + gl_WorkGroupID.x] = line[own];
    memoryBarrierBuffer();  // what every thread has written is visible before the workgroup is counted
    barrier();
    // A loop that runs once at most: a software rasteriser goes through both sides of an `if`, and leaves a loop.
    for (bool last = is_last_workgroup(int(layer), gl_NumWorkGroups.x); last; last = false) finish();
}
