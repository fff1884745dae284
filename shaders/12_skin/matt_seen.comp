// Surfaces other than skin, shaded at the visible point.
#include "05_shadow_maps/shade_seen.glsl"
#include "12_skin/matt.frag"

vec3 seen_radiance(vec4 frag_coord) { return matt_radiance(); }
