// wrong: asked
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"
shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint i = 0u; i < lights_data.length() && has_surface; ++i)
        if (light_reaches_cell(lights_data[i], cell)) add_light(sum, i, surface, facing, position);
    return sum;
}
