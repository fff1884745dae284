// Where neighbours differ: words of edges, and the list of pixels beside an edge.
#include "13_mlaa/lab_edges.glsl"
#include "13_mlaa/list.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/strong_edges.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform MlaaBlock { float threshold; } mlaa;
layout(r32ui) writeonly uniform uimage2D row_words, column_words;  // 13_mlaa/edge_words.glsl
shared uint row_word[tile_side], column_word[tile_side];

vec3 lab_at(ivec2 pixel) {
    vec3 lab = to_lab(light_at(pixel));
#ifdef STRONG_EDGES
    see_lab(pixel - tile_side * ivec2(gl_WorkGroupID.xy), lab);
#endif
    return lab;
}

// [edges]
void main() {
    ivec2 group = ivec2(gl_WorkGroupID.xy), place = ivec2(gl_LocalInvocationID.xy), corner = tile_side * group, pixel = corner + place;
    int thread = int(gl_LocalInvocationIndex);
    uint edges = lab_edges(corner, mlaa.threshold);
    bool inside = all(lessThan(pixel, textureSize(picture, 0)));
    if (thread < tile_side) row_word[thread] = column_word[thread] = 0u;
    put_on_list(inside && edges != 0u, pixel);

    if (listed_here > 0u) {  // as for all threads of the workgroup
        bool right = inside && (edges & 1u) != 0u, below = inside && (edges & 2u) != 0u;
#ifdef STRONG_EDGES
        if (thread < unseen_pixels) lab_at(corner + unseen_place(thread));
        barrier();
        right = right && is_seen(place, ivec2(1, 0));
        below = below && is_seen(place, ivec2(0, 1));
#endif
        if (right || below) {
            atomicOr(row_word[place.y], uint(below) << place.x | uint(right) << place.x + tile_side);
            atomicOr(column_word[place.x], uint(right) << place.y | uint(below) << place.y + tile_side);
        }
        barrier();
    }
    if (thread < tile_side) imageStore(row_words, ivec2(group.x, corner.y + thread), uvec4(row_word[thread]));
    else if (thread < 2 * tile_side) imageStore(column_words, ivec2(corner.x + thread - tile_side, group.y), uvec4(column_word[thread - tile_side]));
}
// [/edges]
