// The sum over the lights that may reach a point.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/arriving.glsl"
#include "03_attenuation/light_grid.glsl"

layout(scalar) readonly buffer LightBuffer { LightData lights[]; };
#if METHOD == METHOD_PER_OBJECT
layout(scalar) readonly buffer ObjectBuffer { uint object_ends[]; };  // where each draw call's list ends
layout(scalar) readonly buffer ObjectLightBuffer { uint object_lights[]; };
#elif METHOD != METHOD_EVERY_LIGHT
layout(scalar) readonly buffer MaskBuffer { uint masks[]; };
layout(scalar) readonly buffer GroupBuffer { uint groups[]; };
#endif
layout(scalar) uniform KnobBlock { float fade_k; } knobs;

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
    uint lights;             // how many were computed
};

// [add_light]
void add_light(inout Lit sum, uint index, Surface surface, vec3 position) {
    ++sum.lights;
    Arriving arriving = arriving_light(lights[index], position, knobs.fade_k);
    if (arriving.radiance == vec3(0.0)) return;
    Reflected reflected = reflect_light(surface, arriving.to_light, Wrap(0.0, 1.0, vec3(1.0)));
    sum.diffuse += arriving.radiance * reflected.diffuse;
    sum.specular += arriving.radiance * reflected.specular;
}
// [/add_light]

// [light_surface]
// Always in the order of the lights: a sum of floats depends on it. `item` is the draw call, `fragment` gl_FragCoord.
Lit light_surface(Surface surface, vec3 position, uint item, vec4 fragment) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
#if METHOD == METHOD_EVERY_LIGHT
    for (uint i = 0u; i < lights.length(); ++i) add_light(sum, i, surface, position);
#elif METHOD == METHOD_PER_OBJECT
    for (uint i = item == 0u ? 0u : object_ends[item - 1u]; i < object_ends[item]; ++i)
        add_light(sum, object_lights[i], surface, position);
#else
    uint cells = cell_count(), cell = cell_of(fragment);
    uint group_count = (lights.length() + LIGHTS_PER_GROUP - 1u) / LIGHTS_PER_GROUP;
    for (uint group = 0u; group < group_count; ++group)
        for (uint used = groups[group * cells + cell]; used != 0u; used &= used - 1u) {
            uint mask = 32u * group + findLSB(used);
            for (uint bits = masks[mask * cells + cell]; bits != 0u; bits &= bits - 1u)
                add_light(sum, LIGHTS_PER_MASK * mask + findLSB(bits), surface, position);
        }
#endif
    return sum;
}
// [/light_surface]
