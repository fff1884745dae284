// Where neighbours differ: words of edges, the list of pixels beside an edge, and their light, which later passes mix.
#include "13_mlaa/lab_edges.glsl"
#include "13_mlaa/list.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/strong_edges.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform MlaaBlock { float threshold; } mlaa;
layout(r32ui) writeonly uniform uimage2D row_words, column_words;  // 13_mlaa/edge_words.glsl
layout(rgba16f) writeonly uniform image2D light_beside;
shared uint row_word[tile_side], column_word[tile_side];

ivec2 corner() { return tile_side * ivec2(gl_WorkGroupID.xy); }

#if DROPS_HIDDEN
// Colours of the square, of one pixel before it and of two behind it: those that lab_edges() asks for, and further ones.
const int colour_side = tile_side + 3;
shared float colours[3][colour_side * colour_side];

int colour_slot(ivec2 pixel) {
    ivec2 at = clamp(pixel - corner() + 1, ivec2(0), ivec2(colour_side - 1));
    return at.y * colour_side + at.x;
}
vec3 colour_at(ivec2 pixel) {
    int slot = colour_slot(pixel);
    return vec3(colours[0][slot], colours[1][slot], colours[2][slot]);
}
vec3 lab_at(ivec2 pixel) {
    vec3 lab = to_lab(light_at(pixel));
    int slot = colour_slot(pixel);
    for (int i = 0; i < 3; ++i) colours[i][slot] = lab[i];
    return lab;
}

// A column, a row, and the corners around the square.
const int further_count = 2 * tile_side + 4;
ivec2 further(int i) {
    if (i < tile_side) return ivec2(tile_side + 1, i);
    if (i < 2 * tile_side) return ivec2(i - tile_side, tile_side + 1);
    return ivec2((i & 1) * (tile_side + 1) - 1, (i >> 1 & 1) * (tile_side + 1) - 1);
}

// The whole workgroup calls it. The edges below a pixel and on its right, less those that stronger ones hide.
uint seen_edges(uint edges, ivec2 pixel) {
    int further_wanted = listed_here > 0u ? further_count : 0;
    for (int i = int(gl_LocalInvocationIndex); i < further_wanted; i += tile_side * tile_side) lab_at(corner() + further(i));
    barrier();
    uint right = (edges & 1u) != 0u ? uint(is_seen(pixel, ivec2(1, 0))) : 0u;
    uint below = (edges & 2u) != 0u ? uint(is_seen(pixel, ivec2(0, 1))) : 0u;
    return right | below << 1;
}
#else
vec3 lab_at(ivec2 pixel) { return to_lab(light_at(pixel)); }
vec3 colour_at(ivec2 pixel) { return lab_at(pixel); }
#endif

void put_into_words(uint edges, ivec2 place) {
    if ((edges & 3u) == 0u) return;
    uint right = edges & 1u, below = edges >> 1 & 1u;
    atomicOr(row_word[place.y], below << place.x | right << place.x + tile_side);
    atomicOr(column_word[place.x], right << place.y | below << place.y + tile_side);
}

void main() {
    ivec2 place = ivec2(gl_LocalInvocationID.xy), pixel = corner() + place;
    int thread = int(gl_LocalInvocationIndex);
    begin_list();
    if (thread < tile_side) row_word[thread] = column_word[thread] = 0u;
    uint edges = lab_edges(corner(), mlaa.threshold);
    barrier();
    edges = all(lessThan(pixel, textureSize(picture, 0))) ? edges : 0u;
#if !DROPS_HIDDEN
    put_into_words(edges, place);
#endif
    if (edges != 0u) imageStore(light_beside, pixel, texelFetch(picture, pixel, 0));
    put_on_list(edges != 0u, pixel);  // has barriers
#if DROPS_HIDDEN
    put_into_words(seen_edges(edges, pixel), place);
    barrier();
#endif
    if (thread < tile_side) imageStore(row_words, ivec2(gl_WorkGroupID.x, corner().y + thread), uvec4(row_word[thread]));
    else if (thread < 2 * tile_side) imageStore(column_words, ivec2(corner().x + thread - tile_side, gl_WorkGroupID.y), uvec4(column_word[thread - tile_side]));
}
