// Light lists of clusters: each invocation tests up to 1,024 lights for one cell and alone writes its masks.
#include "03_attenuation/cell.glsl"

layout(local_size_x = 64) in;
layout(scalar) readonly buffer LightBuffer { LightData lights_data[]; };
layout(scalar) writeonly buffer MaskBuffer { uint lights_masks[]; };
layout(scalar) writeonly buffer GroupBuffer { uint lights_groups[]; };

Cell cell_of_index(uint index) {
    uvec2 tile = uvec2(index % lights_grid.tiles.x, index / lights_grid.tiles.x % lights_grid.tiles.y);
    float slice = float(index / (lights_grid.tiles.x * lights_grid.tiles.y));
    float near = slice == 0.0 ? 0.0 : lights_grid.first_m * exp(slice / lights_grid.slices_per_log);
    return cell_between(tile, near, lights_grid.first_m * exp((slice + 1.0) / lights_grid.slices_per_log));
}

// [main]
void main() {
    uint cell_index = gl_GlobalInvocationID.x, group = gl_GlobalInvocationID.y;
    if (cell_index >= cell_count()) return;
    Cell cell = cell_of_index(cell_index);
    uint masks_used = 0u;
    uint first = group * LIGHTS_PER_GROUP, end = min(first + LIGHTS_PER_GROUP, lights_data.length());
    for (uint mask_first = first; mask_first < end; mask_first += LIGHTS_PER_MASK) {
        uint mask = 0u;
        for (uint i = mask_first; i < min(mask_first + LIGHTS_PER_MASK, end); ++i)
            if (light_reaches_cell(lights_data[i], cell)) mask |= 1u << (i - mask_first);
        if (mask == 0u) continue;
        lights_masks[mask_first / LIGHTS_PER_MASK * cell_count() + cell_index] = mask;
        masks_used |= 1u << (mask_first - first) / LIGHTS_PER_MASK;
    }
    lights_groups[group * cell_count() + cell_index] = masks_used;
}
// [/main]
