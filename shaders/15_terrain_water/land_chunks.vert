// A chunk of the ground. Vertices that the next coarser level lacks move onto their neighbours there before that level is
// reached (F. Strugar, Continuous distance-dependent level of detail, 2009).
#include "15_terrain_water/chunks.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer ChunkListBlock { Chunk chunk_list[]; };

// [morph]
// How far a vertex has moved to its place in level + 1: 0 to 1. A function of its place alone, so that two chunks that
// share a vertex agree. 1 from where any chunk of level + 1 that touches it may be drawn: that with the smallest error.
float morphed(ivec2 at, vec3 point, int level) {
    int side = CHUNK_CELLS << (level + 1);
    ivec2 upper = at / side, lower = (at - 1) / side;
    float error = min(min(chunk_error_at(lower, level + 1), chunk_error_at(upper, level + 1)),
                      min(chunk_error_at(ivec2(lower.x, upper.y), level + 1), chunk_error_at(ivec2(upper.x, lower.y), level + 1)));
    float reached = length(point - chunk_view.from) * chunk_limit();  // the error that is allowed here
    return error <= 0.0 ? 1.0 : clamp((reached / error - 0.7) / 0.299, 0.0, 1.0);
}

vec3 placed(ivec2 at, int level) {
    vec3 point = chunk_point(at);
    if (chunk_view.fixed_level >= 0) return point;
    for (; level < top_level(); ++level) {
        float share = morphed(at, point, level);
        ivec2 next = at & ~ivec2((2 << level) - 1);
        if (share < 1.0) return mix(point, chunk_point(next), share);
        at = next;
        point = chunk_point(at);
    }
    return point;
}
// [/morph]

void main() {
    Chunk chunk;
    if (chunk_view.fixed_level >= 0) {
        int side = 1 << (top_level() - chunk_view.fixed_level);
        chunk = Chunk(gl_InstanceIndex % side, gl_InstanceIndex / side, chunk_view.fixed_level);
    } else {
        chunk = chunk_list[gl_InstanceIndex];
    }
    ivec2 vertex = ivec2(gl_VertexIndex % (CHUNK_CELLS + 1), gl_VertexIndex / (CHUNK_CELLS + 1));
    ivec2 at = (CHUNK_CELLS * ivec2(chunk.x, chunk.z) + vertex) << chunk.level;
    gl_Position = view.view_projection * vec4(placed(at, chunk.level), 1.0);
}
