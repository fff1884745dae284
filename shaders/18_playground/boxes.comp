// Picking by boxes: the item of the nearest bounding box.
#include "common/view_rays.h"
#include "18_playground/id_buffer.glsl"
#include "18_playground/item_box.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) writeonly uniform uimage2D found_ids;
layout(scalar) readonly buffer BoxBuffer { ItemBox boxes[]; };
layout(scalar) uniform ThroughBlock { ViewRays through; };
layout(scalar) uniform CountBlock { uint count; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(found_ids)))) return;
    vec3 direction = ray_through(through, vec2(pixel) + 0.5);
    vec3 inverse = 1.0 / mix(direction, vec3(1e-20), equal(direction, vec3(0.0)));
    float nearest = 1e30;
    uint found = 0u;
    for (uint i = 0u; i < count; ++i) {
        vec3 a = (boxes[i].lower - through.eye) * inverse, b = (boxes[i].upper - through.eye) * inverse;
        vec3 low = min(a, b), high = max(a, b);
        float enter = max(max(low.x, low.y), max(low.z, 0.0)), leave = min(high.x, min(high.y, high.z));
        if (enter > leave || enter >= nearest) continue;
        nearest = enter;
        found = id_of(i);
    }
    imageStore(found_ids, pixel, uvec4(found));
}
