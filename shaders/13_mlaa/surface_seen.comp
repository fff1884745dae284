// The same at the visible point.
#include "05_shadow_maps/shade_seen.glsl"
#include "13_mlaa/clipped.glsl"

vec4 seen_color(vec4 frag_coord) { return vec4(clipped_radiance(seen_surface(), frag_coord), 1.0); }
