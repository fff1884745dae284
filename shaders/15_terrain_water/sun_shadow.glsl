// Sun shadows of houses and objects: the module SunShadow for shaders. Without it, no_sun_shadow.glsl is included
// instead.
#include "05_shadow_maps/shadow.glsl"

float sun_left_by_houses(vec3 position, vec3 normal, vec3 to_sun) { return light_visibility(0u, position, normal, normal, to_sun).r; }

// On a wall, `height_m` above the street.
float sun_left_on_wall(vec3 position, vec3 normal, vec3 to_sun, float height_m) { return sun_left_by_houses(position, normal, to_sun); }
