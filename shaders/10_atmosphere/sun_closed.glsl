// Sunlight by a formula.
#include "10_atmosphere/closed_depth.glsl"
#include "10_atmosphere/sunlight.glsl"

vec3 sun_transmittance(Place place) {
    float share = sun_share(place), height = max(place.height, 0.0);
    return share > 0.0 ? share * exp(-closed_depth(height, max(place.sun, horizon_slope(height)))) : vec3(0.0);
}

vec3 scattered_before(Place place) { return vec3(0.0); }
