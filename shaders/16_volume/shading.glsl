// How a sample shines: by itself, and as its place is lit.
#include "16_volume/gradient.glsl"
#include "16_volume/light_through.glsl"
#include "16_volume/unattenuated_light.glsl"
#include "16_volume/scattering.glsl"

#if VOLUME_SCATTERING == VOLUME_SCATTERING_NONE
// Radiance of a white scatterer there, times pi: without emission.
vec3 light_at(vec3 position) {
#if VOLUME_LIGHT == VOLUME_LIGHT_NONE
    return vec3(0.0);
#elif VOLUME_LIGHT == VOLUME_LIGHT_MARCH
    return unattenuated_light(position) * light_through(position, 0.5, volume.light_steps);
#else
    return unattenuated_light(position) * textureLod(volume_light, to_texture(position), 0.0).r;
#endif
}

vec3 radiance_at(vec3 position, vec3 along, vec3 color) {
    vec3 lit = position;
    vec3 reflected = vec3(1.0);
#if VOLUME_SHADING == VOLUME_SHADING_GRADIENT
    vec3 voxel = 1.0 / volume_now.size, voxel_m = 2.0 * volume_now.half_m * voxel;
    vec3 slope = gradient(waved(to_texture(position)), voxel, voxel_m) * volume_now.to_volume;
    float steep = length(slope);
    vec3 to_light = volume_now.is_near > 0.0 ? normalize(volume_now.light_at - position) : volume_now.light_at;
    vec3 normal = -slope / max(steep, 1e-6);
    float cosine = max(dot(normal, to_light), 0.0);
    float shine = volume.shine * pow(max(dot(normal, normalize(to_light - along)), 1e-4), 40.0);
    float faces = smoothstep(0.2, 1.0, steep);  // where the density hardly changes there is no surface
    reflected = mix(vec3(1.0), vec3(cosine) + shine / max(color, 0.05), faces);
    // The light is that before the surface: within it the surface's own steps, a voxel wide, would shadow it.
    lit += 2.0 * voxel_m.x * faces * normal;
#endif
    return color * (volume.glow + light_at(lit) * reflected / 3.14159265);
}
#endif
