// Shading of a visibility buffer; equals shown.frag.
#include "05_shadow_maps/shade_seen.glsl"
#include "05_shadow_maps/shown.glsl"

vec4 seen_color(vec4 frag_coord) { return shown(frag_coord); }
