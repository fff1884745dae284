// Where each pixel's ray meets the set: how far away, after how many distances, and how it ended.
#include "11_fractals/julia.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

#if JULIA_METHOD == JULIA_METHOD_CONE
uniform sampler2D starts;
#endif
layout(rgba32f) writeonly uniform image2D found;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(found)))) return;
    march_from = julia_now.rays.eye;
    march_along = pixel_direction(pixel);
    vec2 range = within_bound(march_from, march_along);
    float shared_steps = 0.0;
#if JULIA_METHOD == JULIA_METHOD_CONE
    vec2 start = texelFetch(starts, pixel / julia_now.tile, 0).rg;
    range.x = max(range.x, start.x);
    shared_steps = start.y / float(julia_now.tile * julia_now.tile);
#endif
    March march = March(0.0, 0, MARCH_MISS);
    if (range.x < range.y) march = march_julia(range.x, range.y);
    imageStore(found, pixel, vec4(march.t, float(march.steps) + shared_steps, float(march.ended), 0.0));
}
