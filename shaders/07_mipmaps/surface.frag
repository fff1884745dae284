// A surface with all its maps, lit by chapter 03's lights: chapter 04's picture, with the levels of this one.
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

void main() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    Substance s = m.substance;
    vec3 around = (s.mixed.diffuse + s.ambient_specular) * ambient * s.occlusion;
    color = vec4(around + s.mixed.diffuse * lit.diffuse + s.mixed.specular * lit.specular + m.glow, 1.0);
}
