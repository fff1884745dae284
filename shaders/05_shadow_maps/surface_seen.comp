// Surfaces with all their maps and shadows, shaded where they are seen: what surface.frag does.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shade_seen.glsl"
#include "05_shadow_maps/shadow.glsl"

vec3 seen_radiance(vec4 frag_coord) {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    Lit lit = light_surface(m.surface, m.facing, m.position, item, frag_coord);
    return radiance_of(m, lit.diffuse, lit.specular, ambient);
}
