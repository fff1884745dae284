// A surface with all its maps under chapter 03's lights, which may be far brighter than white.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    color = vec4(min(radiance_of(m, lit.diffuse, lit.specular, ambient), LARGEST_HALF), 1.0);
#ifdef TRANSPARENT
    color.a = m.alpha;
#endif
}
