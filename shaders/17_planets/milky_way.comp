// The sky behind the stars of the catalogue.
#include "17_planets/map_lookup.glsl"
#include "17_planets/star_data.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform NowBlock { StarsNow now; };
uniform sampler2D star_map;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec3 direction = normalize(now.to_galaxy * ray_through(now.rays, vec2(pixel) + 0.5));
    // Blurred, since its single stars are the catalogue's once more.
    vec3 light = map_texel(star_map, map_uv(direction), max(length(now.rays.right), 0.05)).rgb;
    imageStore(result, pixel, vec4(now.milky_way * light, 1.0));
}
