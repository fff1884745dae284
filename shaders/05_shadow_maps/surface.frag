// A surface with all its maps, and its shadows.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "04_surface_maps/surface_maps.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "common/put_surface.glsl"

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    put_surface(radiance_of(m, lit.diffuse, lit.specular, ambient), m.alpha);
}
