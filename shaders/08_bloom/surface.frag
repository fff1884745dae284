// A surface with all its maps, lit by chapter 03's lights, which may be far brighter than white.
#include "04_surface_maps/surface_maps.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

layout(location = 0) out vec4 color;

void main() {
    MappedSurface mapped = map_surface(view.eye, materials[material_index], coordinates_at(view));
    if (is_cut_out(mapped.alpha, maps.cutoff)) discard;
    Substance substance = mapped.substance;
    Lit lit = light_surface(mapped.surface, mapped.facing, mapped.position, item, gl_FragCoord);
    vec3 radiance = mapped.glow + substance.mixed.diffuse * lit.diffuse + substance.mixed.specular * lit.specular;
    radiance += (substance.mixed.diffuse + substance.ambient_specular) * ambient * substance.occlusion;
    color = vec4(min(radiance, 65504.0), 1.0);
}
