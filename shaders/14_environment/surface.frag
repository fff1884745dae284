// A surface with all its maps, lit by the scene's lights and by its surroundings.
#include "03_attenuation/lighting.glsl"
#include "04_surface_maps/surface_maps.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "14_environment/image_light.glsl"
#include "14_environment/substance_data.h"

layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer SubstanceBuffer { SubstanceData substances[]; };

// [surface]
void main() {
    MaterialData material = materials[material_index];
    MappedSurface m = map_surface(view.eye, material, coordinates_at(view));
#ifndef TRANSPARENT
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
#endif
    SubstanceData own = substances[item];
    vec3 albedo = m.substance.mixed.diffuse * (1.0 - own.metalness), f0 = m.substance.mixed.specular;
    // Chapter 04 keeps roughness as an exponent of Blinn and Phong's model, as Walter et al. (2007) convert it; where a
    // model's file says how rough a surface is, that is finer.
    float alpha = own.alpha >= 0.0 ? own.alpha : sqrt(2.0 / (m.surface.shininess + 2.0));

    LitFromAround around = LitFromAround(m.position, m.surface.normal, m.surface.to_eye, f0, alpha);
    FromAround reflected = reflected_from_around(around);
    vec3 below = albedo * reflected.diffuse_share * diffuse_light(m.position, m.surface.normal);
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    vec3 body = below * m.substance.occlusion + albedo * lit.diffuse;
    vec3 coat = reflected.specular * m.substance.occlusion + f0 * lit.specular + m.glow;
#ifdef TRANSPARENT
    // What is reflected covers what lies behind; the rest lets it through as far as alpha says.
    float covered = max(schlick_power(dot(around.normal, around.to_eye)), max(f0.r, max(f0.g, f0.b)));
    float opacity = max(1.0 - (1.0 - m.alpha) * (1.0 - covered), 1e-3);
    color = vec4(min((m.alpha * body + coat) / opacity, 65504.0), opacity);
#else
    color = vec4(min(body + coat, 65504.0), 1.0);
#endif
}
// [/surface]
