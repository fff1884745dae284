// Surfaces with all their maps and shadows, shaded at the visible point: equals surface.frag.
#include "05_shadow_maps/shade_seen.glsl"
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/shadow.glsl"

vec3 seen_radiance(vec4 frag_coord) {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    Lit lit = light_mapped(m, item, frag_coord);
    return radiance_of(m, lit.diffuse, lit.specular, ambient);
}
