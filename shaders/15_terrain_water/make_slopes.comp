// The ground's slopes along x and z, by central differences; and their means, level by level.
#include "15_terrain_water/land_data.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform LandMapBlock { LandMap land_map; };
uniform sampler2D heights;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    int last = land_map.samples - 1;
    if (any(greaterThan(at, ivec2(last)))) return;
    ivec2 lower = max(at - 1, 0), upper = min(at + 1, last);
    vec2 rise = vec2(texelFetch(heights, ivec2(upper.x, at.y), 0).r - texelFetch(heights, ivec2(lower.x, at.y), 0).r,
                     texelFetch(heights, ivec2(at.x, upper.y), 0).r - texelFetch(heights, ivec2(at.x, lower.y), 0).r);
    float height = texelFetch(heights, at, 0).r;
    imageStore(result, at, vec4(rise / (vec2(upper - lower) * land_map.spacing_m), height, 0.0));
}
