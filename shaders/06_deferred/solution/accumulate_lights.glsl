// Solution of 06.accumulate_lights (J. Andersson, "Parallel Graphics in Frostbite", SIGGRAPH course, 2009).
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"

shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    const uint threads = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint first = 0u; first < lights_data.length(); first += LIGHTS_PER_GROUP) {
        if (gl_LocalInvocationIndex < tile_lights.length()) tile_lights[gl_LocalInvocationIndex] = 0u;
        barrier();
        uint end = min(first + LIGHTS_PER_GROUP, lights_data.length());
        for (uint i = first + gl_LocalInvocationIndex; i < end; i += threads)
            if (light_reaches_cell(lights_data[i], cell))
                atomicOr(tile_lights[(i - first) / LIGHTS_PER_MASK], 1u << i % LIGHTS_PER_MASK);
        barrier();
        for (uint mask = 0u; mask < tile_lights.length() && has_surface; ++mask)
            for (uint bits = tile_lights[mask]; bits != 0u; bits &= bits - 1u)
                add_light(sum, first + LIGHTS_PER_MASK * mask + findLSB(bits), surface, facing, position);
        barrier();  // no clear while another invocation still reads
    }
    return sum;
}
