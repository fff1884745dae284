// Exercise 06.accumulate_lights: 256 pixels look for their lights together.
// Until you fill it in, every pixel computes every light: the picture is right, and nothing is saved.
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"

// What a workgroup shares: a bit for each of LIGHTS_PER_GROUP (1,024) lights. It holds anything at the start.
shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

// [accumulate_lights]
// The sum of add_light() over the lights i of lights_data, in rising order, for which light_reaches_cell(lights_data[i],
// cell) holds. All 16 x 16 invocations of a tile's workgroup call this at once with the same `cell`, those without a
// surface too: `has_surface` is false for them, and their sum counts for nothing. No light is asked about twice: each
// invocation (gl_LocalInvocationIndex) asks about its share, and tells the others by a bit in tile_lights. There may be
// more lights than tile_lights has bits: take them 1,024 at a time. barrier() is where all wait for all: between what
// one writes and another reads, between what one reads and another clears, and never where some may not come by.
// [/accumulate_lights]
Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint i = 0u; i < lights_data.length(); ++i) add_light(sum, i, surface, facing, position);
    return sum;
}
