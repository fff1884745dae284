// How far the ground's samples lie from the triangles of a coarser level, in metres: for each chunk of that level the
// greatest distance, straight up, of it and of all finer levels. A workgroup for each chunk.
#include "15_terrain_water/land_data.h"
#include "common/opaque.glsl"

layout(local_size_x = 64) in;
uniform sampler2D heights;
uniform sampler2D finer;  // errors of the level before
layout(scalar) uniform ErrorLevelBlock { int error_level; };
layout(r32f) writeonly uniform image2D result;
shared float greatest[64];

bool is_drawn() { return int(gl_GlobalInvocationID.x) >= 0; }

float height_at(ivec2 at) { return texelFetch(heights, at, 0).r; }

// [error]
// On the two triangles of a cell, whose common edge runs from its upper right to its lower left corner.
float coarse_height(ivec2 at, int cell) {
    ivec2 corner = at / cell * cell;
    vec2 t = vec2(at - corner) / float(cell);
    float a = height_at(corner), b = height_at(corner + ivec2(cell, 0));
    float c = height_at(corner + ivec2(0, cell)), d = height_at(corner + cell);
    return t.x + t.y <= 1.0 ? a + t.x * (b - a) + t.y * (c - a) : d + (1.0 - t.x) * (c - d) + (1.0 - t.y) * (b - d);
}
// [/error]

void main() {
    ivec2 chunk = ivec2(gl_WorkGroupID.xy);
    int level = opaque(error_level), cell = 1 << level, side = CHUNK_CELLS * cell;
    float error = 0.0;
    for (int i = int(gl_LocalInvocationIndex); i < side * side; i += 64) {
        ivec2 at = chunk * side + ivec2(i % side, i / side);
        error = max(error, abs(height_at(at) - coarse_height(at, cell)));
    }
    greatest[gl_LocalInvocationIndex] = error;
    barrier();
    if (gl_LocalInvocationIndex != 0u) return;
    for (int i = 1; i < 64; ++i) error = max(error, greatest[i]);
    if (level > 0)
        for (int i = 0; i < 4; ++i) error = max(error, texelFetch(finer, 2 * chunk + ivec2(i & 1, i >> 1), 0).r);
    imageStore(result, chunk, vec4(error));
}
