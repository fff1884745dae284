// The lines of edges around a pixel: where they begin and end.
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/line_scan.glsl"

// A line seen from the pixel `near`, above it or on its left: how many pixels it goes on from there to both ends, that one
// counted. 0 where there is no such edge.
struct EdgeLine {
    ivec2 near, along;
    int back, ahead;
};

#if MLAA_READS == MLAA_READS_WORDS
layout(scalar) uniform MlaaBlock { int reach; } mlaa;

EdgeLine line_at(ivec2 near, bool horizontal) {
    int at = horizontal ? near.x : near.y, line = horizontal ? near.y : near.x;
    LineBreaks found = line_breaks(at >> 4, line, horizontal);
    EdgeLine l = EdgeLine(near, ivec2(horizontal, !horizontal), 0, 0);
    if ((found.missing >> (at & 15) & 1u) != 0u) return l;
    l.back = scan_back(found, at, line, horizontal, mlaa.reach);
    l.ahead = scan_ahead(found, at, line, horizontal, mlaa.reach);
    return l;
}
#else
uniform usampler2D distances;

EdgeLine line_at(ivec2 near, bool horizontal) {
    bool there = horizontal ? edge_below(near) : edge_right(near);
    uint word = there ? texelFetch(distances, near, 0).x >> (horizontal ? back_below : back_right) : 0u;
    return EdgeLine(near, ivec2(horizontal, !horizontal), int(byte_of(word, 0u)), int(byte_of(word, 8u)));
}
#endif
ivec2 first_of(EdgeLine l) { return l.near - (l.back - 1) * l.along; }
ivec2 last_of(EdgeLine l) { return l.near + (l.ahead - 1) * l.along; }

// [beyond_border]
// A line that the picture's border cuts goes on outside. If the silhouette is straight, it is as long there as the line
// before it, beyond the end that is seen, and turns to the other side. `turns` (-1 near, 1 far): at the first pixel and the last.
void go_beyond_border(inout EdgeLine l, inout ivec2 turns) {
    ivec2 size = picture_size(), before = first_of(l) - l.along, behind = last_of(l) + l.along;
    bool leaves_back = any(lessThan(before, ivec2(0))), leaves_ahead = any(greaterThanEqual(behind, size));
    int turn = leaves_back ? turns.y : turns.x;
    if (leaves_back == leaves_ahead || turn == 0) return;
    EdgeLine other = line_at((leaves_back ? behind : before) + turn * l.along.yx, l.along.x != 0);
    int hidden = other.back + other.ahead - (l.back + l.ahead);
    if (hidden < -1) return;  // longer than the one before it: no straight silhouette
    hidden = max(hidden, 0);
    if (leaves_back) {
        l.back += hidden;
        turns.x = -turn;
    } else {
        l.ahead += hidden;
        turns.y = -turn;
    }
}
// [/beyond_border]
