// A surface with all its maps as its surroundings see it: a body below a smooth coat. Car paint is such a body, too.
#include "04_surface_maps/surface_maps.glsl"
#include "14_environment/bump.glsl"
#include "14_environment/paint_model.glsl"
#include "14_environment/substance_data.h"

layout(scalar) uniform SubstanceBlock { float roughness; } substance;
layout(scalar) readonly buffer SubstancesBuffer { SubstanceData substances[]; };

// [coated]
struct CoatedSurface {
    MappedSurface m;
    vec3 albedo;  // of the body, in the light of the scene's lights; 0 for car paint, which has a table for them
    vec3 f0;      // what the coat reflects when looked at straight on
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
    return c;
}
// [/coated]
