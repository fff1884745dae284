// Shading of a visibility buffer with maps and shadows; equals surface.frag.
#include "05_shadow_maps/shade_seen.glsl"
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/shadow.glsl"

vec4 seen_color(vec4 frag_coord) {
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, frag_coord);
    return vec4(radiance_of(m, lit.diffuse, lit.specular, ambient), 1.0);
}
