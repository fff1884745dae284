// The nearest and the farthest depth in each tile, one workgroup a tile. The background, depth 0, does not count.
#include "03_attenuation/light_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
uniform sampler2D depth;
layout(scalar) writeonly buffer TileDepthBuffer { vec2 tile_depths[]; };  // farthest, nearest; (1, 0) where all is background

shared uint farthest, nearest;  // bits of floats above 0, which are in the order of the floats

void main() {
    if (gl_LocalInvocationIndex == 0u) {
        farthest = floatBitsToUint(1.0);
        nearest = 0u;
    }
    barrier();
    uvec2 first = gl_WorkGroupID.xy * lights_grid.tile_px, end = min(first + lights_grid.tile_px, uvec2(lights_grid.size));
    for (uint y = first.y + gl_LocalInvocationID.y; y < end.y; y += 16u)
        for (uint x = first.x + gl_LocalInvocationID.x; x < end.x; x += 16u) {
            uint bits = floatBitsToUint(texelFetch(depth, ivec2(x, y), 0).r);
            if (bits == 0u) continue;
            atomicMin(farthest, bits);
            atomicMax(nearest, bits);
        }
    barrier();
    if (gl_LocalInvocationIndex == 0u)
        tile_depths[gl_WorkGroupID.y * lights_grid.tiles.x + gl_WorkGroupID.x] =
            vec2(uintBitsToFloat(farthest), uintBitsToFloat(nearest));
}
