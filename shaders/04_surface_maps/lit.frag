// Shading of surfaces with maps under chapter 03's lights, in linear HDR.
#include "04_surface_maps/reflection.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "common/put_surface.glsl"

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, gl_FragCoord);
    put_surface(min(radiance_of(m, lit.diffuse, lit.specular, ambient), LARGEST_HALF), m.alpha, m.tint);
}
