// wrong: lights where
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"
shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    uint end = min(LIGHTS_PER_GROUP, lights_data.length());
    if (gl_LocalInvocationIndex < 32u) tile_lights[gl_LocalInvocationIndex] = 0u;
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < end; i += 256u)
        if (light_reaches_cell(lights_data[i], cell)) atomicOr(tile_lights[i / 32u], 1u << i % 32u);
    barrier();
    for (uint i = 0u; i < end && has_surface; ++i)
        if ((tile_lights[i / 32u] >> i % 32u & 1u) != 0u) add_light(sum, i, surface, facing, position);
    return sum;
}
