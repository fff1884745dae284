// A surface with all its maps under chapter 03's lights, which may be far brighter than white.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/surface_maps.glsl"
#include "common/put_surface.glsl"

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    put_surface(min(radiance_of(m, lit.diffuse, lit.specular, ambient), LARGEST_HALF), m.alpha);
}
