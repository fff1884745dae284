// What houses and objects leave of the sun's light: what the module SunShadow gives to shaders. Where it gives nothing,
// no_sun_shadow.glsl stands in its place.
#include "05_shadow_maps/shadow.glsl"

float sun_left_by_houses(vec3 position, vec3 normal, vec3 to_sun) { return light_visibility(0u, position, normal, to_sun).r; }

// On a wall, `height_m` above the street.
float sun_left_on_wall(vec3 position, vec3 normal, vec3 to_sun, float height_m) { return sun_left_by_houses(position, normal, to_sun); }
