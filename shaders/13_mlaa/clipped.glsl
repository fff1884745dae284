// A surface with all its maps and shadows. Light is clipped to the displayable range here, if that is to happen
// before pixels are mixed.
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/shadow.glsl"

vec3 clipped_radiance(MappedSurface m, vec4 frag_coord) {
    Lit lit = light_mapped(m, item, frag_coord);
    vec3 radiance = radiance_of(m, lit.diffuse, lit.specular, ambient);
#if CLIP == CLIP_BEFORE
    radiance = min(radiance, 1.0);
#endif
    return min(radiance, LARGEST_HALF);
}
