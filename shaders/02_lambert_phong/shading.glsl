// The sum over all directional lights, for a vertex or a fragment.
#include "02_lambert_phong/lights.h"
#include "02_lambert_phong/reflection.glsl"

layout(scalar) readonly buffer LightBuffer { DirectionalLight lights[]; };
layout(scalar) uniform KnobBlock {
    float shininess;  // 0: each material's own
    float wrap;
    float wrap_power;
    vec3 wrap_tint;
    int samples;
} knobs;

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
};

// [sum]
Lit light_surface(vec3 position, vec3 normal, vec3 eye, float material_shininess) {
    Surface surface;
    surface.normal = normal;
    surface.to_eye = normalize(eye - position);
    surface.shininess = knobs.shininess > 0.0 ? knobs.shininess : material_shininess;
    Wrap wrap = Wrap(knobs.wrap, knobs.wrap_power, knobs.wrap_tint);
    Lit sum = Lit(vec3(0.0), vec3(0.0));
    for (int i = 0; i < lights.length(); ++i) {
        Reflected reflected = reflect_light(surface, lights[i].to_light, wrap);
        sum.diffuse += lights[i].radiance * reflected.diffuse;
        sum.specular += lights[i].radiance * reflected.specular;
    }
    return sum;
}
// [/sum]
