// A flat grid of rings around the eye, each of cells twice as large as the one within, lifted to the ground's height.
#include "11_fractals/terrain.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };

layout(location = 0) out vec3 position;

bool is_drawn() { return gl_VertexIndex >= 0; }

// [place]
// A ring's outer edge has twice as many vertices as the ring around it. Those that the other has not move onto their
// neighbours: what is left of their triangles closes without a crack.
vec2 place_of(ivec2 vertex, int ring) {
    ivec2 last = ivec2(terrain_now.cells);
#if TERRAIN_STITCH
    if (ring + 1 < terrain_now.rings) {
        if (vertex.x == 0 || vertex.x == last.x) vertex.y &= ~1;
        if (vertex.y == 0 || vertex.y == last.y) vertex.x &= ~1;
    }
#endif
    return vec2(vertex - last / 2) * (terrain_now.spacing_m * float(1 << ring));
}
// [/place]

void main() {
    int side = terrain_now.cells + 1;
    vec2 place = place_of(ivec2(gl_VertexIndex % side, gl_VertexIndex / side), gl_InstanceIndex);
    // What the grid can show here: the same number for both rings at their common edge.
    float grid_m = max(max(abs(place.x), abs(place.y)) * 2.0 / float(terrain_now.cells), 0.5 * terrain_now.spacing_m);
    float pixel_m = pixel_footprint(length(vec3(place.x, 0.0, place.y) - terrain_now.eye));
    position = vec3(place.x, terrain_at(place, octaves_for(max(grid_m, pixel_m))).x, place.y);
    gl_Position = view.view_projection * vec4(position, 1.0);
}
