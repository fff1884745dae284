// Shading of surfaces with maps and shadows.
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "common/put_surface.glsl"

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, gl_FragCoord);
    put_surface(radiance_of(m, lit.diffuse, lit.specular, ambient), m.alpha, m.tint);
}
