// A surface with all its maps, lit by the scene's lights and by its surroundings. Car paint is a layer below a clear coat.
// Whoever includes it says what stands in the way of light: unoccluded.glsl or occluded.glsl.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "04_surface_maps/surface_maps.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "14_environment/bump.glsl"
#include "14_environment/image_light.glsl"
#include "14_environment/paint.glsl"
#include "14_environment/substance_data.h"
#include "common/put_surface.glsl"

layout(scalar) uniform SubstanceBlock { float roughness; } substance;
layout(scalar) readonly buffer SubstancesBuffer { SubstanceData substances[]; };

// [paint_lights]
// What the scene's lights leave of paint, by its table; each light's radiance is what a matt white surface shows.
vec3 paint_lights(MappedSurface m, float n_dot_v) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < lights_data.length(); ++i) {
        Arriving arriving = arriving_light(lights_data[i], m.position, lights.fade_k);
        float n_dot_l = dot(m.surface.normal, arriving.to_light);
        if (n_dot_l <= 0.0 || dot(m.facing, arriving.to_light) <= 0.0) continue;
        vec3 visible = light_visibility(i, m.position, m.facing, arriving.to_light);
        sum += pi * n_dot_l * visible * arriving.radiance * paint_brdf(n_dot_l, n_dot_v);
    }
    return sum;
}
// [/paint_lights]

// [surface]
void main() {
    MaterialData material = materials[material_index];
    MappedSurface m = map_surface(view.eye, material, coordinates_at(view));
#ifndef TRANSPARENT
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
#endif
    SubstanceData own = substances[item];
    if (own.bump_depth > 0.0)
        m.surface.normal = bumped(m.surface.normal, m.position, own.bumps_per_m, own.bump_depth);
    vec3 normal = m.surface.normal, to_eye = m.surface.to_eye;
    float n_dot_v = clamp(dot(normal, to_eye), 1e-3, 1.0);
    bool is_paint = own.paint == 1u;
    vec3 albedo = m.substance.mixed.diffuse * (1.0 - own.metalness);
    vec3 f0 = is_paint ? vec3(coat_f0) : m.substance.mixed.specular;
    // Chapter 04 keeps roughness as an exponent of Blinn and Phong's model, as Walter et al. (2007) convert it; where a
    // model's file says how rough a surface is, that is finer.
    float alpha = own.alpha >= 0.0 ? own.alpha : sqrt(2.0 / (m.surface.shininess + 2.0));
    if (substance.roughness >= 0.0) alpha = substance.roughness * substance.roughness;
    if (is_paint) alpha = paint.coat_roughness * paint.coat_roughness;

    FromAround reflected = reflected_from_around(LitFromAround(m.position, normal, to_eye, f0, alpha));
#ifdef OCCLUDED
    vec3 around = diffuse_of_samples(m.position, normal, uint(image_light.samples));
#else
    vec3 around = diffuse_light(m.position, normal);
#endif
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    vec3 body;
    if (is_paint)
        body = paint_albedo(n_dot_v, 0) * around * m.substance.occlusion + paint_lights(m, n_dot_v) +
               paint_albedo(n_dot_v, 1) * flake_light(m.position, normal, to_eye);
    else
        body = albedo * (reflected.diffuse_share * around * m.substance.occlusion + lit.diffuse);
    vec3 coat = reflected.specular * m.substance.occlusion + f0 * lit.specular + m.glow;
#ifdef TRANSPARENT
    // What is reflected covers what lies behind; the rest lets it through as far as alpha says.
    float covered = mix(max(f0.r, max(f0.g, f0.b)), 1.0, schlick_power(n_dot_v));
    float opacity = max(1.0 - (1.0 - m.alpha) * (1.0 - covered), 1e-3);
    put_surface(min((m.alpha * body + coat) / opacity, 65504.0), opacity);
#else
    put_surface(min(body + coat, 65504.0), 1.0);
#endif
}
// [/surface]
