// The split sum's table: a workgroup for each texel. x is n·v, y is alpha; both from 0 to 1 at the middles of the first and
// the last texel.
#include "14_environment/split_sum_table.glsl"

layout(local_size_x = 256) in;

layout(scalar) uniform TableSamplesBlock { uint table_samples; };
layout(rgba16f) writeonly uniform image2D table;

void main() {
    uvec2 texel = gl_WorkGroupID.xy, size = uvec2(imageSize(table));
    vec2 at = vec2(texel) / vec2(max(size, uvec2(2u)) - 1u);
    // Straight along the surface and without any roughness there is nothing to divide by.
    vec2 found = split_sum_table(max(at.x, 1e-3), max(at.y, 1e-3), table_samples, gl_LocalInvocationIndex);
    if (gl_LocalInvocationIndex == 0u) imageStore(table, ivec2(texel), vec4(found, 0.0, 1.0));
}
