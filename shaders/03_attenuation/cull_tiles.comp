// Light lists of tiles, one workgroup per tile.
#include "03_attenuation/cell.glsl"

layout(local_size_x = 256) in;
uniform sampler2D depth;
layout(scalar) readonly buffer LightBuffer { LightData lights_data[]; };
layout(scalar) writeonly buffer MaskBuffer { uint lights_masks[]; };
layout(scalar) writeonly buffer GroupBuffer { uint lights_groups[]; };

// Interface of tile_lights.glsl.
const uint TILE_INVOCATIONS = 256u;
Cell cell;
bool is_empty;

uint tile_pixels() { return lights_grid.tile_px * lights_grid.tile_px; }

float tile_depth(uint pixel) {
    uvec2 at = gl_WorkGroupID.xy * lights_grid.tile_px + uvec2(pixel % lights_grid.tile_px, pixel / lights_grid.tile_px);
    return at.x < uint(lights_grid.size.x) && at.y < uint(lights_grid.size.y) ? texelFetch(depth, ivec2(at), 0).r : 0.0;
}

uint light_count() { return lights_data.length(); }

bool light_reaches_tile(uint light) { return !is_empty && light_reaches_cell(lights_data[light], cell); }

#include "03_attenuation/tile_lights.glsl"

void main() {
    uint local = gl_LocalInvocationIndex, index = gl_WorkGroupID.y * lights_grid.tiles.x + gl_WorkGroupID.x;
    vec2 depths = tile_depth_range(local);
    is_empty = depths.x > depths.y;
    cell = cell_between(gl_WorkGroupID.xy, view_depth(depths.y), view_depth(depths.x));
    for (uint group = 0u; group * LIGHTS_PER_GROUP < light_count(); ++group) {
        find_tile_lights(local, group);
        if (local < 32u && tile_masks[local] != 0u)
            lights_masks[(32u * group + local) * cell_count() + index] = tile_masks[local];
        if (local != 0u) continue;
        uint masks_used = 0u;
        for (uint mask = 0u; mask < 32u; ++mask)
            if (tile_masks[mask] != 0u) masks_used |= 1u << mask;
        lights_groups[group * cell_count() + index] = masks_used;
    }
}
