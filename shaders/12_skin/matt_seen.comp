// What is no skin, shaded where it is seen.
#include "05_shadow_maps/shade_seen.glsl"
#include "12_skin/matt.frag"

vec3 seen_radiance(vec4 frag_coord) { return matt_radiance(); }
