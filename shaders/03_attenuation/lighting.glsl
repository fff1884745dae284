// The sum over the lights that may reach a point.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/arriving.glsl"

layout(scalar) readonly buffer LightBuffer { LightData lights[]; };
layout(scalar) uniform KnobBlock {
    float fade_k;
} knobs;

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
};

// [add_light]
void add_light(inout Lit sum, uint index, Surface surface, vec3 position) {
    Arriving arriving = arriving_light(lights[index], position, knobs.fade_k);
    if (arriving.radiance == vec3(0.0)) return;
    Reflected reflected = reflect_light(surface, arriving.to_light, Wrap(0.0, 1.0, vec3(1.0)));
    sum.diffuse += arriving.radiance * reflected.diffuse;
    sum.specular += arriving.radiance * reflected.specular;
}
// [/add_light]

Lit light_surface(Surface surface, vec3 position) {
    Lit sum = Lit(vec3(0.0), vec3(0.0));
    for (uint i = 0u; i < lights.length(); ++i) add_light(sum, i, surface, position);
    return sum;
}
