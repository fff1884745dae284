// Sunlight, and light that was scattered before, from tables.
#include "10_atmosphere/read_tables.glsl"
#include "10_atmosphere/sunlight.glsl"

uniform sampler2D air_multiple;  // radiance after many scatterings, per unit of the sun's light: multiple_uv

vec3 sun_transmittance(Place place) {
    float share = sun_share(place), height = clamp(place.height, 0.0, air.top);
    return share > 0.0 ? share * read_transmittance(height, max(place.sun, horizon_slope(height))) : vec3(0.0);
}

vec3 scattered_before(Place place) {
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    vec2 size = vec2(textureSize(air_multiple, 0));
    return air.sun * textureLod(air_multiple, multiple_uv(place, size), 0.0).rgb;
#else
    return vec3(0.0);
#endif
}
