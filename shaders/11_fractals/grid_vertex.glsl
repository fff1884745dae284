// A vertex of the terrain's grid: flat rings around the eye, each of cells twice as large as the one within, lifted to the
// ground's height.
#include "11_fractals/ring_grid.glsl"
#include "11_fractals/terrain.glsl"

#if TERRAIN_STITCH
const bool stitch = true;
#else
const bool stitch = false;
#endif

// Metres from the grid's middle.
vec3 grid_vertex(int number, int ring) {
    int side = terrain_now.cells + 1;
    ivec2 vertex = ivec2(number % side, number / side);
    ivec2 cell = ring_place(vertex, ring, terrain_now.cells, terrain_now.rings, stitch);
    vec2 place = vec2(cell) * terrain_now.spacing_m;
    // The grid's finest detail here: the same number for both rings at their common edge.
    float grid_m = max(max(abs(place.x), abs(place.y)) * 2.0 / float(terrain_now.cells), 0.5 * terrain_now.spacing_m);
    float pixel_m = pixel_footprint(length(vec3(place.x, 0.0, place.y) - terrain_now.eye));
    return vec3(place.x, terrain_at(place, octaves_for(max(grid_m, pixel_m))).x, place.y);
}
