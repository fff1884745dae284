// The sum over the lights that may reach a point: what the module Lights gives to shaders.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/arriving.glsl"
#include "03_attenuation/light_grid.glsl"

layout(scalar) readonly buffer LightBuffer { LightData lights_data[]; };
#if LIGHTS_METHOD == LIGHTS_METHOD_PER_OBJECT
layout(scalar) readonly buffer ObjectBuffer { uint lights_object_ends[]; };  // where each draw call's list ends
layout(scalar) readonly buffer ObjectLightBuffer { uint lights_of_objects[]; };
#elif LIGHTS_METHOD != LIGHTS_METHOD_EVERY_LIGHT
layout(scalar) readonly buffer MaskBuffer { uint lights_masks[]; };
layout(scalar) readonly buffer GroupBuffer { uint lights_groups[]; };
#endif
layout(scalar) uniform LightsBlock { float fade_k; } lights;

// What of a light's way to a point is free, 0 to 1. Whoever lights says how: by 03_attenuation/unshadowed.glsl, which
// takes all for free, or by a file that knows what stands in between. `facing` is the normal of the mesh.
float light_visibility(uint light, vec3 position, vec3 facing, vec3 to_light);

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
    uint lights;             // how many were computed
};

// [add_light]
void add_light(inout Lit sum, uint index, Surface surface, vec3 facing, vec3 position) {
    ++sum.lights;
    Arriving arriving = arriving_light(lights_data[index], position, lights.fade_k);
    if (arriving.radiance == vec3(0.0)) return;
    arriving.radiance *= float(dot(facing, arriving.to_light) > 0.0);  // a second branch costs 5 % on an H200
    arriving.radiance *= light_visibility(index, position, facing, arriving.to_light);
    Reflected reflected = reflect_light(surface, arriving.to_light);
    sum.diffuse += arriving.radiance * reflected.diffuse;
    sum.specular += arriving.radiance * reflected.specular;
}
// [/add_light]

// [light_surface]
// `facing` is the normal of the mesh: what is below its plane does not light the surface, whatever a normal map says.
// Always in the order of the lights: a sum of floats depends on it. `item` is the scene's item, `fragment` gl_FragCoord.
Lit light_surface(Surface surface, vec3 facing, vec3 position, uint item, vec4 fragment) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
#if LIGHTS_METHOD == LIGHTS_METHOD_EVERY_LIGHT
    for (uint i = 0u; i < lights_data.length(); ++i) add_light(sum, i, surface, facing, position);
#elif LIGHTS_METHOD == LIGHTS_METHOD_PER_OBJECT
    for (uint i = item == 0u ? 0u : lights_object_ends[item - 1u]; i < lights_object_ends[item]; ++i)
        add_light(sum, lights_of_objects[i], surface, facing, position);
#else
    uint cells = cell_count(), cell = cell_of(fragment);
    uint group_count = (lights_data.length() + LIGHTS_PER_GROUP - 1u) / LIGHTS_PER_GROUP;
    for (uint group = 0u; group < group_count; ++group)
        for (uint used = lights_groups[group * cells + cell]; used != 0u; used &= used - 1u) {
            uint mask = 32u * group + findLSB(used);
            for (uint bits = lights_masks[mask * cells + cell]; bits != 0u; bits &= bits - 1u)
                add_light(sum, LIGHTS_PER_MASK * mask + findLSB(bits), surface, facing, position);
        }
#endif
    return sum;
}
// [/light_surface]
