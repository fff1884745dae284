// Where neighbours differ: words of edges, the list of pixels beside an edge, and their light, which later passes mix.
#include "13_mlaa/lab_edges.glsl"
#include "13_mlaa/list.glsl"
#include "13_mlaa/picture.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform MlaaBlock { float threshold; } mlaa;
layout(r32ui) writeonly uniform uimage2D row_words, column_words;  // 13_mlaa/edge_words.glsl
layout(rgba16f) writeonly uniform image2D light_beside;
shared uint row_word[tile_side], column_word[tile_side];

vec3 lab_at(ivec2 pixel) { return to_lab(light_at(pixel)); }

// [edges]
void main() {
    ivec2 group = ivec2(gl_WorkGroupID.xy), place = ivec2(gl_LocalInvocationID.xy), corner = tile_side * group, pixel = corner + place;
    int thread = int(gl_LocalInvocationIndex);
    begin_list();
    if (thread < tile_side) row_word[thread] = column_word[thread] = 0u;
    uint edges = lab_edges(corner, mlaa.threshold);
    barrier();
    edges = all(lessThan(pixel, textureSize(picture, 0))) ? edges : 0u;
    if ((edges & 3u) != 0u) {
        uint right = edges & 1u, below = edges >> 1 & 1u;
        atomicOr(row_word[place.y], below << place.x | right << place.x + tile_side);
        atomicOr(column_word[place.x], right << place.y | below << place.y + tile_side);
    }
    if (edges != 0u) imageStore(light_beside, pixel, texelFetch(picture, pixel, 0));
    put_on_list(edges != 0u, pixel);  // has barriers
    if (thread < tile_side) imageStore(row_words, ivec2(group.x, corner.y + thread), uvec4(row_word[thread]));
    else if (thread < 2 * tile_side) imageStore(column_words, ivec2(corner.x + thread - tile_side, group.y), uvec4(column_word[thread - tile_side]));
}
// [/edges]
