// The ground as rings around the eye, chapter 11's grid, lifted to the map's heights.
#include "11_fractals/ring_grid.glsl"
#include "15_terrain_water/ground.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform LandRingsBlock {
    ivec2 middle;  // samples
    int cells, rings;
} land_rings;

void main() {
    int cells = land_rings.cells, side = cells + 1;
    ivec2 vertex = ivec2(gl_VertexIndex % side, gl_VertexIndex / side);
    ivec2 at = land_rings.middle + ring_place(vertex, gl_InstanceIndex, cells, land_rings.rings, true);
    at = clamp(at, ivec2(0), ivec2(land_map.samples - 1));
    vec2 place = land_map.corner + land_map.spacing_m * vec2(at);
    gl_Position = view.view_projection * vec4(place.x, land_sample(at), place.y, 1.0);
}
