// Tiled lighting, one workgroup per 16 x 16 pixels: depth range, lights in reach, their sum.
layout(local_size_x = 16, local_size_y = 16) in;  // before the first use of gl_WorkGroupSize

#include "06_deferred/read_gbuffer.glsl"
#include "06_deferred/put_light.glsl"
#include "06_deferred/accumulate_lights.glsl"

shared uint farthest, nearest;  // bits of positive floats, which sort as the floats do

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThan(at, imageSize(hdr)));
    float depth = inside ? depth_of(at) : 0.0;
    if (gl_LocalInvocationIndex == 0u) {
        farthest = floatBitsToUint(1.0);
        nearest = 0u;
    }
    barrier();
    if (depth > 0.0) {
        atomicMin(farthest, floatBitsToUint(depth));
        atomicMax(nearest, floatBitsToUint(depth));
    }
    barrier();
    if (inside && depth == 0.0) put_background(at);
    if (nearest != 0u) {  // uniform over the group
        Cell cell = cell_between(gl_WorkGroupID.xy, view_depth(uintBitsToFloat(nearest)), view_depth(uintBitsToFloat(farthest)));
        Pixel p = read_pixel(min(at, imageSize(hdr) - 1), max(depth, uintBitsToFloat(farthest)));
        Lit lit = accumulate_lights(surface_of(p, view.eye), p.facing, p.position, cell, depth > 0.0);
        if (depth > 0.0) put_light(at, p, lit);
    }
}
