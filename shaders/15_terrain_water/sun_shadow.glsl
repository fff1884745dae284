// What houses and objects leave of the sun's light: what the module SunShadow gives to shaders.
#ifdef SUN_SHADOW
#include "05_shadow_maps/shadow.glsl"

float sun_left_by_houses(vec3 position, vec3 normal, vec3 to_sun) { return light_visibility(0u, position, normal, to_sun).r; }
#else
float sun_left_by_houses(vec3 position, vec3 normal, vec3 to_sun) { return 1.0; }
#endif
