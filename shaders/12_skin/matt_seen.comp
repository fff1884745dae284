// Surfaces other than skin, shaded at the visible point.
#include "05_shadow_maps/shade_seen.glsl"
#include "12_skin/matt.frag"

vec4 seen_color(vec4 frag_coord) { return vec4(matt_radiance(), 1.0); }
