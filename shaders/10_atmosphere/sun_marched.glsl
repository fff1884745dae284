// Sunlight by marching from each place out of the air.
#include "10_atmosphere/marched_depth.glsl"
#include "10_atmosphere/sunlight.glsl"

int light_steps();  // the pass says how many
bool light_steps_grow();

vec3 sun_transmittance(Place place) {
    float share = sun_share(place), height = clamp(place.height, 0.0, air.top);
    if (share <= 0.0) return vec3(0.0);
    return share * exp(-marched_depth(height, max(place.sun, horizon_slope(height)), light_steps(), light_steps_grow()));
}

vec3 scattered_before(Place place) { return vec3(0.0); }
