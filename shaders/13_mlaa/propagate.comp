// Distances along edges become two or four times as long, in four directions.
#define WORK_ACCESS readonly
#include "13_mlaa/propagate_distance.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;

layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(scalar) uniform StepBlock { ivec2 directions[4]; int reads, reach; } pass_step;
layout(r32ui) writeonly uniform uimage2D into;

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        known_from = unpack_pixel(listed[i]);
        uint own = texelFetch(from, known_from, 0).x, longer = 0u;
        for (uint d = 0u; d < 4u; ++d) {
            known_shift = 8u * d;
            known_direction = pass_step.directions[d];
            if (byte_of(own, known_shift) > 0u) longer |= 1u + propagate_distance(pass_step.reads, uint(pass_step.reach) - 1u) << known_shift;
        }
        imageStore(into, known_from, uvec4(longer));
    }
}
