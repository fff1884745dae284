// The item of the nearest triangle behind each pixel.
#include "common/view_rays.h"
#include "05_shadow_maps/bvh.glsl"
#include "18_playground/id_buffer.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) writeonly uniform uimage2D found_ids;
layout(scalar) readonly buffer TriangleItemBuffer { uint triangle_items[]; };
layout(scalar) uniform ThroughBlock { ViewRays through; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(found_ids)))) return;
    vec3 direction = ray_through(through, vec2(pixel) + 0.5);
    RayHit hit;
    bool met = closest_hit(Ray(through.eye, 0.0, direction, 1e30), hit);
    imageStore(found_ids, pixel, uvec4(met ? id_of(triangle_items[hit.triangle]) : 0u));
}
