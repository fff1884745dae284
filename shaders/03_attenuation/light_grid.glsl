// Which cell of the grid a fragment is in.
#include "03_attenuation/grid_view.h"

layout(scalar) uniform LightsGridBlock { GridView lights_grid; };

uint cell_count() { return lights_grid.tiles.x * lights_grid.tiles.y * lights_grid.slices; }

// Metres in front of the eye. 1 / z is linear in what a depth buffer holds.
float view_depth(float depth) { return 1.0 / (lights_grid.inverse_far + depth * (lights_grid.inverse_near - lights_grid.inverse_far)); }

// [cell_of]
// `fragment` is gl_FragCoord.
uint cell_of(vec4 fragment) {
    uvec2 tile = uvec2(fragment.xy) / lights_grid.tile_px;
    float slice = floor(log(view_depth(fragment.z) / lights_grid.first_m) * lights_grid.slices_per_log);
    return (uint(clamp(slice, 0.0, float(lights_grid.slices - 1u))) * lights_grid.tiles.y + tile.y) * lights_grid.tiles.x + tile.x;
}
// [/cell_of]
