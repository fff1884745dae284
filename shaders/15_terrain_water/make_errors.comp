// How far the ground's samples lie from the triangles of a coarser level, in metres: for each chunk of that level, its
// border with it, the greatest distance of it and of all finer levels. A workgroup for each chunk.
#include "15_terrain_water/land_data.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D heights;
uniform sampler2D finer;  // errors of the level before
layout(scalar) uniform ErrorLevelBlock {
    int level;
    float spacing_m;
} error_level;
layout(r32f) writeonly uniform image2D result;
shared float greatest[64];

float height_at(ivec2 at) { return texelFetch(heights, at, 0).r; }

// From the plane of one of the two triangles of a cell, with the common edge from its upper right to its lower left
// corner. On a wall that is far less than the vertical distance, which is invisible from in front.
float distance_from_cell(ivec2 at, ivec2 corner, int cell) {
    vec2 t = vec2(at - corner) / float(cell);
    float a = height_at(corner), b = height_at(corner + ivec2(cell, 0));
    float c = height_at(corner + ivec2(0, cell)), d = height_at(corner + cell);
    bool first = t.x + t.y <= 1.0;
    vec2 rise = first ? vec2(b - a, c - a) : vec2(d - c, d - b);
    float above = height_at(at) - (first ? a + dot(t, rise) : d - dot(1.0 - t, rise));
    vec2 slope = rise / (float(cell) * error_level.spacing_m);
    return abs(above) * inversesqrt(1.0 + dot(slope, slope));
}

void main() {
    ivec2 chunk = ivec2(gl_WorkGroupID.xy);
    int level = error_level.level, cell = 1 << level, side = CHUNK_CELLS * cell;
    float error = 0.0;
    ivec2 thread = ivec2(gl_LocalInvocationID.xy);
    for (int y = thread.y; y <= side; y += 8)
        for (int x = thread.x; x <= side; x += 8) {
            ivec2 within = ivec2(x, y), corner = min(within >> level, ivec2(CHUNK_CELLS - 1)) << level;
            error = max(error, distance_from_cell(chunk * side + within, chunk * side + corner, cell));
        }
    greatest[gl_LocalInvocationIndex] = error;
    barrier();
    if (gl_LocalInvocationIndex != 0u) return;
    for (int i = 1; i < 64; ++i) error = max(error, greatest[i]);
    if (level > 0)
        for (int i = 0; i < 4; ++i) error = max(error, texelFetch(finer, 2 * chunk + ivec2(i & 1, i >> 1), 0).r);
    imageStore(result, chunk, vec4(error));
}
