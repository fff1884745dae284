// The picture in fog.
#include "10_atmosphere/height_fog_inputs.glsl"
#include "common/view_rays.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform FogSunBlock { vec4 fog_sun; };  // to the sun; how far the sky is, metres

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5);
    float stored = texelFetch(depth, pixel, 0).r, stretch = length(ray);
    vec3 direction = ray / stretch;
    float distance = stored > 0.0 ? stretch * distance_along_view(rays, stored) : fog_sun.w;
    float above = rays.eye.y - fog.base_m;
    if (stored == 0.0 && above > 0.0 && direction.y < 0.0) distance = min(distance, above / -direction.y);
    vec4 seen = imageLoad(result, pixel);
    imageStore(result, pixel, vec4(through_fog(seen.rgb, rays.eye, direction, distance, fog_sun.xyz), seen.a));
}
