// What of a light arrives at a point.
#include "03_attenuation/light_data.h"
#include "03_attenuation/range_fade.glsl"
#include "03_attenuation/inverse_square_window.glsl"
#include "03_attenuation/spot_cone.glsl"

struct Arriving {
    vec3 to_light;  // unit length; no length where the point is the light's own position
    vec3 radiance;  // linear; a matt white surface that faces the light shows just this
};

// [falloff]
// How much weaker than at 1 m.
float falloff(float distance, float range, float fade_k) {
#if LIGHTS_FALLOFF == LIGHTS_FALLOFF_RANGE_FADE
    return range_fade(distance, range, fade_k);
#elif LIGHTS_FALLOFF == LIGHTS_FALLOFF_INVERSE_SQUARE
    return 1.0 / max(distance * distance, 1e-4);  // no lamp is smaller than 1 cm
#else
    return inverse_square_window(distance, range);
#endif
}
// [/falloff]

// [arriving_light]
Arriving arriving_light(LightData light, vec3 position, float fade_k) {
    if (light.kind == LIGHT_DIRECTIONAL) return Arriving(-light.direction, light.radiance);
    vec3 offset = light.position - position;
    float distance = length(offset);
    vec3 to_light = distance > 0.0 ? offset / distance : vec3(0.0);
    float factor = falloff(distance, light.range, fade_k);
    if (light.kind == LIGHT_SPOT)
        factor *= spot_cone(-dot(to_light, light.direction), light.cos_inner, light.cos_outer, light.softness);
    return Arriving(to_light, light.radiance * factor);
}
// [/arriving_light]
