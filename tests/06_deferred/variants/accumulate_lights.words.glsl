// right
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"
shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

// Each of 32 invocations fills a word of its own: no atomics.
Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    uint me = gl_LocalInvocationIndex;
    for (uint first = 0u; first < lights_data.length(); first += 1024u) {
        if (me < 32u) {
            uint word = 0u;
            for (uint i = 0u; i < 32u && first + 32u * me + i < lights_data.length(); ++i)
                if (light_reaches_cell(lights_data[first + 32u * me + i], cell)) word |= 1u << i;
            tile_lights[me] = word;
        }
        barrier();
        if (has_surface)
            for (uint i = 0u; i < 1024u; ++i)
                if ((tile_lights[i / 32u] & 1u << i % 32u) != 0u) add_light(sum, first + i, surface, facing, position);
        barrier();
    }
    return sum;
}
