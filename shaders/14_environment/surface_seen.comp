// Opaque surfaces in the light of their surroundings, shaded at the visible point: equals surface.frag.
#include "05_shadow_maps/shade_seen.glsl"
#include "14_environment/lit_around.glsl"
#include "14_environment/unoccluded.glsl"

vec4 seen_color(vec4 frag_coord) {
    CoatedSurface c = coated_surface();
    Leaving light = lit_around(c, frag_coord);
    return vec4(min(light.body + light.coat, LARGEST_HALF), 1.0);
}
