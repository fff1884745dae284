// Exercise 06.accumulate_lights: one light search shared by the 256 pixels of a tile.
// Starter: every pixel computes every light: the picture is right, and nothing is saved.
#include "03_attenuation/cell.glsl"
#include "03_attenuation/lighting.glsl"

// Shared by the workgroup: one bit for each of LIGHTS_PER_GROUP (1,024) lights. Its content is undefined at the start.
shared uint tile_lights[LIGHTS_PER_GROUP / LIGHTS_PER_MASK];

// [accumulate_lights]
// Returns the sum of add_light() over the lights i of lights_data, in increasing order, for
// which light_reaches_cell(lights_data[i], cell) holds. All 16 x 16 invocations of a tile's
// workgroup call this function together with the same `cell`. Those without a surface call
// it too: `has_surface` is false for them, and their sum is ignored.
// A tile tests no light twice: each invocation (gl_LocalInvocationIndex) tests its share of
// the lights and tells the others by a bit in tile_lights. There may be more lights than
// tile_lights has bits: process them 1,024 at a time. At barrier() all invocations wait for
// each other: it belongs between a write by one and a read by another, and between a read
// by one and a clear by another. It must never stand where some invocations do not arrive.
// [/accumulate_lights]
Lit accumulate_lights(Surface surface, vec3 facing, vec3 position, Cell cell, bool has_surface) {
    Lit sum = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint i = 0u; i < lights_data.length(); ++i) add_light(sum, i, surface, facing, position);
    return sum;
}
