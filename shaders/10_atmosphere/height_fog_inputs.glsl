// The module HeightFog for shaders: fog between a point and the eye.
#include "10_atmosphere/height_fog.glsl"

layout(scalar) uniform FogBlock {
    float density, falloff, base_m, start_m, sun_power;
    vec3 color, sun_color;
} fog;

// Transmittance from a point `distance` metres away (0 or more) in a direction of unit length.
float fog_transmittance(vec3 eye, vec3 direction, float distance) {
    float start = min(fog.start_m, distance);
    float y = eye.y + start * direction.y - fog.base_m;
#if FOG_METHOD == FOG_METHOD_NONE
    return 1.0;
#elif FOG_METHOD == FOG_METHOD_UNIFORM
    return exp(-fog.density * (distance - start));
#else
    float falloff = fog.falloff;
    return exp(-height_fog(fog.density, falloff, max(y, -60.0 / max(falloff, 1e-9)), direction.y, distance - start));
#endif
}

// Light scattered by the fog itself: towards the sun the sun's colour. `to_sun` has unit length.
vec3 fog_color(vec3 direction, vec3 to_sun) {
    float towards = pow(clamp(0.5 + 0.5 * dot(direction, to_sun), 1e-6, 1.0), fog.sun_power);
    return mix(fog.color, fog.sun_color, towards);
}

// The light of a point, as it arrives.
vec3 through_fog(vec3 radiance, vec3 eye, vec3 direction, float distance, vec3 to_sun) {
    return mix(fog_color(direction, to_sun), radiance, fog_transmittance(eye, direction, distance));
}
