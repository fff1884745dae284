// A surface with all its maps as its surroundings see it: a body below a smooth coat. Car paint is such a body, too.
#include "04_surface_maps/surface_maps.glsl"
#include "11_fractals/lattice.glsl"
#include "14_environment/paint_model.glsl"
#include "14_environment/substance_data.h"

// Bumps of a surface without texture coordinates: the gradient of noise in space turns the normal.

float bump_corner(ivec3 cell) { return lattice(cell.xy + ivec2(7919, 104729) * cell.z); }

// Value noise and its gradient, smooth by t² (3 - 2 t).
vec4 bump_noise(vec3 p) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - vec3(cell), s = f * f * (3.0 - 2.0 * f), slope = 6.0 * f * (1.0 - f);
    vec4 found = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, i >> 1 & 1, i >> 2);
        vec3 near = vec3(corner), w = mix(1.0 - s, s, near), dw = mix(-slope, slope, near);
        float height = bump_corner(cell + corner);
        found += height * vec4(dw.x * w.y * w.z, w.x * dw.y * w.z, w.x * w.y * dw.z, w.x * w.y * w.z);
    }
    return found;
}

// Change of a position on the surface from this pixel to the next ones.
#ifdef SEEN
vec3 across(vec3 position) { return position_across(); }
vec3 down(vec3 position) { return position_down(); }
#else
vec3 across(vec3 position) { return dFdx(position); }
vec3 down(vec3 position) { return dFdy(position); }
#endif

// J. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978: the normal less the gradient's part along the surface.
// `bumps_per_m` bumps in a metre, `depth` of a bump as a share of its width. Bumps below two pixels are left out.
vec3 bumped(vec3 normal, vec3 position, float bumps_per_m, float depth) {
    float pixels = 1.0 / max(bumps_per_m * max(length(across(position)), length(down(position))), 1e-9);
    vec3 gradient = depth * clamp(pixels - 1.0, 0.0, 1.0) * bump_noise(position * bumps_per_m).xyz;
    return normalize(normal - (gradient - dot(gradient, normal) * normal));
}

layout(scalar) uniform SubstanceBlock { float roughness; } substance;
layout(scalar) readonly buffer SubstancesBuffer { SubstanceData substances[]; };

struct CoatedSurface {
    MappedSurface m;
    vec3 albedo;  // of the body, in the light of the scene's lights; 0 for car paint, which has a table for them
    vec3 f0;      // the coat's reflectance at normal incidence
    float alpha;  // of the coat: GGX, the square of roughness
    bool is_paint;
};

// This fragment's.
CoatedSurface coated_surface() {
    CoatedSurface c;
    c.m = seen_surface();
    SubstanceData own = substances[item];
    if (own.bump_depth > 0.0)
        c.m.surface.normal = bumped(c.m.surface.normal, c.m.position, own.bumps_per_m, own.bump_depth);
    c.is_paint = own.paint == 1u;
    c.albedo = c.is_paint ? vec3(0.0) : c.m.substance.mixed.diffuse * (1.0 - own.metalness);
    c.f0 = c.is_paint ? vec3(coat_f0) : c.m.substance.mixed.specular;
    // Chapter 04 keeps roughness as an exponent of Blinn and Phong's model, as Walter et al. (2007) convert it; where a
    // model's file says how rough a surface is, that is finer.
    c.alpha = own.alpha >= 0.0 ? own.alpha : sqrt(2.0 / (c.m.surface.shininess + 2.0));
    if (substance.roughness >= 0.0) c.alpha = substance.roughness * substance.roughness;
    if (c.is_paint) c.alpha = paint.coat_roughness * paint.coat_roughness;
    c.m.surface.shininess = shininess_of(c.m.surface.shininess, c.alpha);
    return c;
}
