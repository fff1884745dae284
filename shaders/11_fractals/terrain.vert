// A flat grid of rings around the eye, each of cells twice as large as the one within, lifted to the ground's height.
#include "11_fractals/ring_grid.glsl"
#include "11_fractals/terrain.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };

layout(location = 0) out vec3 position;

bool is_drawn() { return gl_VertexIndex >= 0; }

#if TERRAIN_STITCH
const bool stitch = true;
#else
const bool stitch = false;
#endif

void main() {
    int side = terrain_now.cells + 1;
    ivec2 vertex = ivec2(gl_VertexIndex % side, gl_VertexIndex / side);
    ivec2 cell = ring_place(vertex, gl_InstanceIndex, terrain_now.cells, terrain_now.rings, stitch);
    vec2 place = vec2(cell) * terrain_now.spacing_m;
    // What the grid can show here: the same number for both rings at their common edge.
    float grid_m = max(max(abs(place.x), abs(place.y)) * 2.0 / float(terrain_now.cells), 0.5 * terrain_now.spacing_m);
    float pixel_m = pixel_footprint(length(vec3(place.x, 0.0, place.y) - terrain_now.eye));
    position = vec3(place.x, terrain_at(place, octaves_for(max(grid_m, pixel_m))).x, place.y);
    gl_Position = view.view_projection * vec4(position, 1.0);
}
