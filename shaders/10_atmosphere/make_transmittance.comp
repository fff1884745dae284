// The table of transmittance: each texel marches one ray out of the air.
#include "10_atmosphere/marched_depth.glsl"
#include "10_atmosphere/table_uv.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(result));
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec2 place = table_place((vec2(texel) + 0.5) / size, air.radius, air.top, size);
    imageStore(result, texel, vec4(exp(-marched_depth(place.x, place.y, 40, true)), 1.0));
}
