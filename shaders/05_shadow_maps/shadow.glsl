// What of a light arrives behind what stands in its way: what the module Shadow gives to shaders. Whoever lights by
// 03_attenuation/lighting.glsl includes it instead of 03_attenuation/unshadowed.glsl.
#include "05_shadow_maps/visibility_in_map.glsl"

// [light_visibility]
float light_visibility(uint light, vec3 position, vec3 facing, vec3 to_light) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return 1.0;
#else
    // What faces away is dark by itself, and no map is asked.
    if (dot(facing, to_light) <= 0.0) return 0.0;
    return visibility_in_map(shadow_lights[light], position, facing, to_light);
#endif
}
// [/light_visibility]
