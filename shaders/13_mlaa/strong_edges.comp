// Drops hidden edges of listed pixels, after edges.comp: for devices that run both sides of a branch.
#define WORK_ACCESS readonly
#include "13_mlaa/picture.glsl"
#include "13_mlaa/strong_edges.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(r32ui) uniform uimage2D row_words, column_words;  // 13_mlaa/edge_words.glsl

vec3 colour_at(ivec2 pixel) { return to_lab(light_at(pixel)); }

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
