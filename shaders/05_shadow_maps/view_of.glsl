// Which of a light's views sees a point.
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/light_clip_position.glsl"
#include "05_shadow_maps/shadow_inputs.glsl"

// [cube_face]
// The face of a cube through which a direction leaves it: +x, -x, +y, -y, +z, -z.
uint cube_face(vec3 direction) {
    vec3 size = abs(direction);
    uint axis = size.x >= size.y && size.x >= size.z ? 0u : size.y >= size.z ? 1u : 2u;
    return 2u * axis + uint(direction[axis] < 0.0);
}
// [/cube_face]

// [view_of]
// Of cascades the finest that holds the point and around it all that a filter may read.
uint view_of(ShadowLight light, vec3 position) {
    if (light.kind == LIGHT_POINT) return light.first_view + cube_face(position - light.position);
    uint last = light.first_view + light.views - 1u;
    for (uint view = light.first_view; view < last; ++view) {
        vec2 place = light_clip_position(shadow_views[view].to_clip, position).xy;
        if (all(lessThanEqual(abs(place - 0.5), vec2(0.5 - MAP_MARGIN)))) return view;
    }
    return last;
}
// [/view_of]
