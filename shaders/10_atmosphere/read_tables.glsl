// Parameterisation of the air's tables.
#include "10_atmosphere/air.glsl"
#include "10_atmosphere/table_uv.glsl"

uniform sampler2D air_transmittance;  // of a ray out of the air: table_uv

vec3 read_transmittance(float height, float slope) {
    vec2 size = vec2(textureSize(air_transmittance, 0));
    return textureLod(air_transmittance, table_uv(height, slope, air.radius, air.top, size), 0.0).rgb;
}

// 0 and 1 at the middles of the first and last texel, and back.
vec2 to_middles(vec2 x, vec2 size) { return (0.5 + clamp(x, 0.0, 1.0) * (size - 1.0)) / size; }
vec2 from_middles(vec2 uv, vec2 size) { return clamp((uv * size - 0.5) / (size - 1.0), 0.0, 1.0); }

// Of the table of multiple scattering: the sun's cosine across, closer where it sets; the height's root down.
vec2 multiple_uv(Place place, vec2 size) {
    float x = 0.5 + 0.5 * sign(place.sun) * sqrt(abs(place.sun));
    return to_middles(vec2(x, sqrt(clamp(place.height / air.top, 0.0, 1.0))), size);
}

Place multiple_place(vec2 uv, vec2 size) {
    vec2 at = from_middles(uv, size);
    float x = 2.0 * at.x - 1.0;
    return Place(at.y * at.y * air.top, x * abs(x));
}
