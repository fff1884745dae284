// A frame of Jupiter's clouds, as a map: chapters/17_planets/sequence/carry_clouds.cpp keeps it.
#include "17_planets/flow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform DaysBlock { float days; };
uniform sampler2D body_map;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 uv = (vec2(texel) + 0.5) / vec2(size);
    imageStore(result, texel, flowed(body_map, body_map, uv, 3.14159265 / float(size.y), days, 1.0));
}
