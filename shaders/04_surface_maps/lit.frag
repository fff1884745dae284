// A surface with all its maps under chapter 03's lights, which may be far brighter than white.
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

void main() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
#ifndef TRANSPARENT
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
#endif
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    color = vec4(min(radiance_of(m, lit.diffuse, lit.specular, ambient), 65504.0), 1.0);
#ifdef TRANSPARENT
    color.a = m.alpha;
#endif
}
