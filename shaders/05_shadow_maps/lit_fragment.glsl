// A fragment with all its maps, lit by chapter 03's lights as far as light_visibility() says they are visible.
#include "03_attenuation/lighting.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

// [lit_fragment]
// Linear radiance towards the eye. What textures cut out is discarded, unless alpha mixes it with what lies behind.
vec3 lit_fragment(out MappedSurface m) {
    m = map_surface(view.eye, materials[material_index], coordinates_at(view));
#ifndef TRANSPARENT
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
#endif
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    return radiance_of(m, lit.diffuse, lit.specular, ambient);
}
// [/lit_fragment]
