// Sum over directional lights, for a vertex or a fragment.
#include "02_lambert_phong/directional_light.h"
#include "02_lambert_phong/reflection.glsl"
#include "02_lambert_phong/phong.glsl"
#include "02_lambert_phong/wrapped_diffuse.glsl"

layout(scalar) readonly buffer LightBuffer { DirectionalLight lights[]; };
layout(scalar) uniform KnobBlock {
    float shininess;  // 0: each material's own
    float wrap;
    float wrap_power;
    vec3 wrap_tint;
} knobs;

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
};

// Reflection by the method in use; Gouraud evaluates the normalised model at vertices.
Reflected reflect_by_method(Surface surface, vec3 to_light) {
    Reflected result = reflect_light(surface, to_light);
#if METHOD == METHOD_PHONG
    // Phong's lobe around the mirror direction is half as wide in angle: a quarter of the exponent matches the widths.
    result.specular = vec3(phong(surface.normal, to_light, surface.to_eye, 0.25 * surface.shininess));
#elif METHOD == METHOD_BLINN_PHONG
    result.specular = vec3(blinn_phong(surface.normal, to_light, surface.to_eye, surface.shininess));
#endif
#if DIFFUSE == DIFFUSE_WRAPPED
    float cosine = dot(surface.normal, to_light);
    result.diffuse = wrapped_diffuse(cosine, knobs.wrap, knobs.wrap_power) * wrapped_tint(cosine, knobs.wrap_tint);
#endif
    return result;
}

Lit light_surface(vec3 position, vec3 normal, vec3 eye, float material_shininess) {
    Surface surface;
    surface.normal = normal;
    surface.to_eye = normalize(eye - position);
    surface.shininess = knobs.shininess > 0.0 ? knobs.shininess : material_shininess;
    Lit sum = Lit(vec3(0.0), vec3(0.0));
    for (int i = 0; i < lights.length(); ++i) {
        Reflected reflected = reflect_by_method(surface, lights[i].to_light);
        sum.diffuse += lights[i].radiance * reflected.diffuse;
        sum.specular += lights[i].radiance * reflected.specular;
    }
    return sum;
}
