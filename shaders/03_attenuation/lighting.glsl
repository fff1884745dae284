// Sum over lights at a point: GLSL of the module Lights.
#include "common/structs.h"
#include "03_attenuation/light_data.h"
#include "03_attenuation/range_fade.glsl"
#include "03_attenuation/inverse_square_window.glsl"
#include "03_attenuation/spot_cone.glsl"

struct Arriving {
    vec3 to_light;  // unit length; zero at the light's own position
    vec3 radiance;  // linear; the radiance of a white Lambertian surface facing the light
};

// Attenuation relative to 1 m.
float falloff(float distance, float range, float fade_k) {
#if LIGHTS_FALLOFF == LIGHTS_FALLOFF_RANGE_FADE
    return range_fade(distance, range, fade_k);
#elif LIGHTS_FALLOFF == LIGHTS_FALLOFF_INVERSE_SQUARE
    return 1.0 / max(distance * distance, 1e-4);  // lamps are at least 1 cm away
#else
    return inverse_square_window(distance, range);
#endif
}

// Lights of glTF files have a softness below 0: the inverse square, up to their range, whatever `falloff` the scene's
// own lights have, and a cone whose edge is a square (KHR_lights_punctual).
float punctual_falloff(float distance, float range) {
    float share = min(distance / range, 1.0), square = share * share;
    return (1.0 - square * square) / max(distance * distance, 1e-12);  // finite at the light itself
}

// [arriving_light]
Arriving arriving_light(LightData light, vec3 position, float fade_k) {
    if (light.kind == LIGHT_DIRECTIONAL) return Arriving(-light.direction, light.radiance);
    vec3 offset = light.position - position;
    float distance = length(offset);
    vec3 to_light = distance > 0.0 ? offset / distance : vec3(0.0);
    float factor = light.softness < 0.0 ? punctual_falloff(distance, light.range) : falloff(distance, light.range, fade_k);
    if (light.kind == LIGHT_SPOT)
        factor *= spot_cone(-dot(to_light, light.direction), light.cos_inner, light.cos_outer, light.softness);
    return Arriving(to_light, light.radiance * factor);
}
// [/arriving_light]

layout(scalar) readonly buffer LightBuffer { LightData lights_data[]; };
#if LIGHTS_METHOD == LIGHTS_METHOD_PER_OBJECT
layout(scalar) readonly buffer ObjectBuffer { uint lights_object_ends[]; };  // end of each draw call's list
layout(scalar) readonly buffer ObjectLightBuffer { uint lights_of_objects[]; };
#elif LIGHTS_METHOD != LIGHTS_METHOD_EVERY_LIGHT
layout(scalar) readonly buffer MaskBuffer { uint lights_masks[]; };
layout(scalar) readonly buffer GroupBuffer { uint lights_groups[]; };
#endif
layout(scalar) uniform LightsBlock { float fade_k; } lights;

// Visibility of a light per colour, 0 to 1. `facing`: interpolated mesh normal; `plane`: normal of the triangle, or
// `facing` where the surface has none. Defined by the includer: 03_attenuation/unshadowed.glsl, or a file with shadows.
vec3 light_visibility(uint light, vec3 position, vec3 facing, vec3 plane, vec3 to_light);

// Reflection model: 02_lambert_phong/reflection.glsl for callers of light_surface().
Reflected reflect_light(Surface surface, vec3 to_light);

struct Lit {
    vec3 diffuse, specular;  // per unit of the material's colours
    uint lights;             // number of lights computed
};

// is_above() and reflect_lamp(): point or finite lamp.
#include "03_attenuation/lamp_points.glsl"

// [add_light]
void add_light(inout Lit sum, uint index, Surface surface, vec3 facing, vec3 position) {
    ++sum.lights;
    Arriving arriving = arriving_light(lights_data[index], position, lights.fade_k);
    if (arriving.radiance == vec3(0.0)) return;
    vec3 to_light = arriving.to_light;
    arriving.radiance *= float(is_above(facing, index, position, to_light));  // a second branch costs 5 % on an H200
    arriving.radiance *= light_visibility(index, position, facing, surface.plane, to_light);
    Reflected reflected = reflect_lamp(surface, index, position, to_light);
    sum.diffuse += arriving.radiance * reflected.diffuse;
    sum.specular += arriving.radiance * reflected.specular;
}
// [/add_light]

// Cell of gl_FragCoord.
uint cell_of(vec4 fragment) {
    uvec2 tile = uvec2(fragment.xy) / lights_grid.tile_px;
    float slice = floor(log(view_depth(fragment.z) / lights_grid.first_m) * lights_grid.slices_per_log);
    return (uint(clamp(slice, 0.0, float(lights_grid.slices - 1u))) * lights_grid.tiles.y + tile.y) * lights_grid.tiles.x + tile.x;
}

// Lights below the plane of the mesh normal `facing` are ignored, despite the normal map. The order of the sum is
// fixed, since float sums depend on it. `item`: scene item; `fragment`: gl_FragCoord.
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

// Single light, for surfaces with their own reflection models.
struct VisibleLight {
    vec3 to_light;  // unit length
    vec3 radiance;  // unshadowed radiance of a white Lambertian surface facing the light
    vec3 visible;   // 0 to 1; 1 where the surface faces away
};

VisibleLight visible_light(uint index, vec3 position, vec3 facing, vec3 plane) {
    Arriving arriving = arriving_light(lights_data[index], position, lights.fade_k);
    bool faces = dot(facing, arriving.to_light) > 0.0;
    vec3 visible = faces && arriving.radiance != vec3(0.0)
                       ? light_visibility(index, position, facing, plane, arriving.to_light)
                       : vec3(1.0);
    return VisibleLight(arriving.to_light, arriving.radiance, visible);
}
