// Which cell of the grid a fragment is in.
#include "03_attenuation/grid_view.h"

layout(scalar) uniform GridBlock { GridView grid; };

uint cell_count() { return grid.tiles.x * grid.tiles.y * grid.slices; }

// Metres in front of the eye. 1 / z is linear in what a depth buffer holds.
float view_depth(float depth) { return 1.0 / (grid.inverse_far + depth * (grid.inverse_near - grid.inverse_far)); }

// [cell_of]
// `fragment` is gl_FragCoord.
uint cell_of(vec4 fragment) {
    uvec2 tile = uvec2(fragment.xy) / grid.tile_px;
    float slice = floor(log(view_depth(fragment.z) / grid.first_m) * grid.slices_per_log);
    return (uint(clamp(slice, 0.0, float(grid.slices - 1u))) * grid.tiles.y + tile.y) * grid.tiles.x + tile.x;
}
// [/cell_of]
