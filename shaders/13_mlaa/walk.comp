// How far staircases go on, step by step, without passes that double.
#define WORK_ACCESS readonly
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(scalar) uniform MlaaBlock { int reach; } mlaa;
layout(r32ui) writeonly uniform uimage2D staircases;

// Steps of a staircase from a pixel's on, itself counted, where `ahead` is 1 downwards and -1 upwards. Four are asked at once:
// none of these reads waits for another.
const uint asked = 4u;
uint walked(ivec2 pixel, int way, int ahead, uint reach) {
    for (uint steps = 1u; steps < reach; steps += asked) {
        uint ends = 1u << asked;
        for (uint k = 0u; k < asked; ++k) {
            ivec2 at = pixel + int(steps + k - 1u) * ahead * ivec2(way, 1);
            ends |= uint(!(ahead > 0 ? follows_after(at, way) : follows_before(at, way))) << k;
        }
        uint more = uint(findLSB(ends));
        if (more < asked) return min(steps + more, reach);
    }
    return reach;
}

uint staircase(ivec2 pixel, int way) {
    if (!is_step(pixel, way)) return 0u;
    return walked(pixel, way, -1, uint(mlaa.reach)) | walked(pixel, way, 1, uint(mlaa.reach)) << 8;
}

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        imageStore(staircases, pixel, uvec4(staircase(pixel, 1) << back_falling | staircase(pixel, -1) << back_rising));
    }
}
