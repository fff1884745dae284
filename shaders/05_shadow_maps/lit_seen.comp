// Shading of a visibility buffer without shadows; equals chapter 04's lit.frag.
#include "05_shadow_maps/shade_seen.glsl"
#include "04_surface_maps/reflection.glsl"
#include "03_attenuation/unshadowed.glsl"

vec4 seen_color(vec4 frag_coord) {
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, frag_coord);
    return vec4(min(radiance_of(m, lit.diffuse, lit.specular, ambient), LARGEST_HALF), 1.0);
}
