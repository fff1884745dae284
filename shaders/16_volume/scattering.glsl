// Light that the volume scatters towards the eye: once, and estimates of the higher orders.
#include "16_volume/light_through.glsl"
#include "16_volume/source_term.glsl"
#include "16_volume/unattenuated_light.glsl"

#if VOLUME_SCATTERING != VOLUME_SCATTERING_NONE
vec3 albedo_of(vec3 color) { return min(volume.albedo * color, 1.0); }

vec3 radiance_at(vec3 position, vec3 along, vec3 color) {
    vec3 irradiance = unattenuated_light(position), to_light = way_to_light(position).xyz, albedo = albedo_of(color);
#if VOLUME_LIGHT == VOLUME_LIGHT_NONE
    irradiance = vec3(0.0);
    float depth = 0.0;
#elif VOLUME_LIGHT == VOLUME_LIGHT_MARCH
    float depth = light_depth(position, 0.5, volume.light_steps);
#else
    float depth = textureLod(volume_light, to_texture(position), 0.0).r;
#endif
    vec3 source = source_term(albedo, volume.glow * color, volume.sky, irradiance, to_light, along, volume.g, depth);
    float cosine = dot(to_light, along);
#if VOLUME_SCATTERING == VOLUME_SCATTERING_OCTAVES
    // [octaves]
    // Each octave has half the extinction, half the light and half the mean cosine of the one before (M. Wrenninge,
    // C. Kulla and V. Lundqvist, "Oz: the great and volumetric", SIGGRAPH Talks 2013).
    float share = 1.0;
    for (int i = 1; i < volume.octaves; ++i) {
        share *= 0.5;
        source += albedo * irradiance * share * phase(cosine, share * volume.g) * exp(-share * depth);
    }
    // [/octaves]
#elif VOLUME_SCATTERING == VOLUME_SCATTERING_CONSERVING
    // [conserving]
    // Octave i stands for light that was scattered 2^i times: n scatterings of mean cosine g have the mean cosine g^n. It
    // gets what half the extinction lets through of what the octave before has lost.
    float share = 1.0, g = volume.g, before = exp(-depth);
    vec3 scattered = albedo;
    for (int i = 1; i < volume.octaves; ++i) {
        share *= 0.5;
        g *= g;
        scattered *= scattered;
        float through = exp(-share * depth);
        source += scattered * irradiance * (through - before) * phase(cosine, g);
        before = through;
    }
    // [/conserving]
#endif
    return source;
}
#endif
