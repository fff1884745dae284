// The view from below the surface: everything through water.
#include "common/view_rays.h"
#include "15_terrain_water/water_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform WaterNowBlock { WaterNow water_now; };
layout(scalar) uniform WaterRaysBlock { ViewRays water_rays; };
uniform sampler2D depth;
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture)))) return;
    vec3 ray = ray_through(water_rays, vec2(at) + 0.5);
    float way = distance_along_view(water_rays, max(texelFetch(depth, at, 0).r, 1e-7)) * length(ray);
    // Light that is scattered on the way has come down through the water above it.
    vec3 from_above = exp(-water_now.absorption * max(water_now.eye_depth_m, 0.0));
    vec3 scattered = water_now.turbid * from_above *
                     (water_now.sky + water_now.sun * max(water_now.to_sun.y, 0.0) / 3.14159265);
    vec3 left = exp(-water_now.absorption * way);
    vec4 before = imageLoad(picture, at);
    imageStore(picture, at, vec4(mix(scattered, before.rgb, left), before.a));
}
