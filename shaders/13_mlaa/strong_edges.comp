// Edges that much stronger ones beside them hide are dropped (J. Jimenez et al., 2012, section 4.1: local contrast).
#define WORK_ACCESS readonly
#include "13_mlaa/lab_distance.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) uniform uimage2D row_words, column_words;  // 13_mlaa/edge_words.glsl

const float hidden_by = 2.0;  // as often as strong

// [strong_edges]
// The edge between a pixel and the next one is seen where none of those around it is more than twice as strong: along the
// same axis before and behind it, and across it at either of its two pixels.
bool is_seen(ivec2 pixel, ivec2 along) {
    ivec2 across = along.yx, next = pixel + along;
    vec3 here = to_lab(light_at(pixel)), there = to_lab(light_at(next));
    float strongest = max(lab_distance(here, to_lab(light_at(pixel - along))), lab_distance(there, to_lab(light_at(next + along))));
    for (int side = -1; side <= 1; side += 2) {
        strongest = max(strongest, lab_distance(here, to_lab(light_at(pixel + side * across))));
        strongest = max(strongest, lab_distance(there, to_lab(light_at(next + side * across))));
    }
    return hidden_by * lab_distance(here, there) >= strongest;
}
// [/strong_edges]

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]), tile = pixel >> 4, bit = pixel & 15;
        // Other threads change other bits of these words meanwhile; nobody else changes this pixel's.
        uint word = imageLoad(row_words, ivec2(tile.x, pixel.y)).x >> bit.x;
        bool below = (word & 1u) != 0u, right = (word >> 16 & 1u) != 0u;
        bool hides_below = below && !is_seen(pixel, ivec2(0, 1)), hides_right = right && !is_seen(pixel, ivec2(1, 0));
        if (!hides_below && !hides_right) continue;
        imageAtomicAnd(row_words, ivec2(tile.x, pixel.y), ~(uint(hides_below) << bit.x | uint(hides_right) << bit.x + 16));
        imageAtomicAnd(column_words, ivec2(pixel.x, tile.y), ~(uint(hides_right) << bit.y | uint(hides_below) << bit.y + 16));
    }
}
