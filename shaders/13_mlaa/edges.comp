// Where neighbours differ: the first distances along edges, and the list of pixels beside an edge.
#include "13_mlaa/lab_edges.glsl"
#include "13_mlaa/list.glsl"
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/picture.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform MlaaBlock { float threshold; } mlaa;
layout(r32ui) writeonly uniform uimage2D seeds;
layout(r32ui) writeonly uniform uimage2D next;  // what no later pass writes is 0 there, too
#ifdef DIAGONALS
layout(r32ui) writeonly uniform uimage2D diagonal_seeds;
layout(r32ui) writeonly uniform uimage2D diagonal_next;
#endif

vec3 lab_at(ivec2 pixel) { return to_lab(light_at(pixel)); }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = textureSize(picture, 0);
    uint edges = lab_edges(tile_side * ivec2(gl_WorkGroupID.xy), mlaa.threshold);
    bool inside = all(lessThan(pixel, size));
    if (inside) {
        uint right = edges & 1u, below = edges >> 1 & 1u;
        imageStore(seeds, pixel, uvec4(right * seed_of_right | below * seed_of_below));
        imageStore(next, pixel, uvec4(0u));
#ifdef DIAGONALS
        imageStore(diagonal_seeds, pixel, uvec4(0u));
        imageStore(diagonal_next, pixel, uvec4(0u));
#endif
    }
    put_on_list(inside && edges != 0u, pixel);
}
