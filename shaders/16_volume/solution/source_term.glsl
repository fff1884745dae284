// Solution of 16.source_term.
#include "16_volume/phase.glsl"

vec3 source_term(vec3 albedo, vec3 emitted, vec3 sky, vec3 irradiance, vec3 to_light, vec3 along, float g, float depth) {
    vec3 scattered = sky + irradiance * exp(-depth) * phase(dot(to_light, along), g);
    return (1.0 - albedo) * emitted + albedo * scattered;
}
