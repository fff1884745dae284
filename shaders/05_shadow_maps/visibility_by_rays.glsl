// What visibility_in_map() is asked, answered by rays.
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/rays.glsl"
#include "05_shadow_maps/shadow_data.h"

// [lamp_of]
// `to_light` has unit length and is what a directional light goes by.
Lamp lamp_of(ShadowLight light, vec3 position, vec3 to_light) {
    if (light.kind == LIGHT_DIRECTIONAL) return Lamp(to_light, 0.5 * light.size, on_and_on);
    return Lamp(light.position - position, 0.5 * light.size, 1.0);
}
// [/lamp_of]

// [visibility_by_rays]
float visibility_by_rays(ShadowLight light, vec3 position, vec3 facing, vec3 to_light) {
    if (light.views == 0u) return 1.0;  // it casts no shadow
    vec3 origin = above(position, facing);
    return lamp_visibility(lamp_of(light, origin, to_light), origin, rays_seed);
}
// [/visibility_by_rays]
