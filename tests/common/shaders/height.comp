// Height in metres of what each pixel shows.
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform RaysBlock { ViewRays rays; };  // pass.set("rays", view_rays(view))
uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D into;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(into)))) return;
    // [position_body]
    float stored = texelFetch(depth, pixel, 0).r;  // 0: nothing is there
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5);
    vec3 position = rays.eye + ray * distance_along_view(rays, max(stored, 1e-7));
    // [/position_body]
    imageStore(into, pixel, vec4(position.y));
}
