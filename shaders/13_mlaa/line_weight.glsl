// How much of a pixel the outline along one line of edges gives to the pixel on the other side.
#include "13_mlaa/line_ends.glsl"

uniform sampler2D areas;  // by the pixels to the end that turns, and to the other, each less one

float area_at(uint to_end, uint to_other) { return texelFetch(areas, ivec2(to_end, to_other) - 1, 0).r; }

// [line_weight]
// `near` is the pixel above or on the left of the edge; `side` is -1 where the share of that pixel is asked for, 1 where
// that of the one across.
float line_weight(ivec2 near, bool horizontal, int side) {
    uint word = distances_at(near);
    uint back = byte_of(word, horizontal ? back_below : back_right), ahead = byte_of(word, horizontal ? ahead_below : ahead_right);
    if (back == 0u) return 0.0;
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
    ivec2 ends = line_ends(near - int(back - 1u) * along, near + int(ahead - 1u) * along, horizontal);
    return (ends.x == side ? area_at(back, ahead) : 0.0) + (ends.y == side ? area_at(ahead, back) : 0.0);
}
// [/line_weight]

#ifdef CROSSINGS
uniform sampler2D crossings;  // by what stands across at an end and at the other: to which side the outline turns there

// What stands across the line at an end: 0 nothing that it turns to, 1 an edge on the near side, 2 on the far side, 3 both.
int across_at(ivec2 before, ivec2 beyond, ivec2 across, bool horizontal) {
    bool near = horizontal ? edge_right(before) : edge_below(before);
    bool far = horizontal ? edge_right(before + across) : edge_below(before + across);
    if ((horizontal ? edge_below(beyond) : edge_right(beyond)) && !(near && far)) return 0;
    return int(near) + 2 * int(far);
}

// As line_weight(), but an end with edges on both sides is told by the other end.
float crossed_line_weight(ivec2 near, bool horizontal, int side) {
    uint word = distances_at(near);
    int back = int(byte_of(word, horizontal ? back_below : back_right)), ahead = int(byte_of(word, horizontal ? ahead_below : ahead_right));
    if (back == 0) return 0.0;
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1), across = along.yx;
    ivec2 first = near - (back - 1) * along, last = near + (ahead - 1) * along;
    int at_first = across_at(first - along, first - along, across, horizontal), at_last = across_at(last, last + along, across, horizontal);
    float first_turn = texelFetch(crossings, ivec2(at_first, at_last), 0).r, last_turn = texelFetch(crossings, ivec2(at_last, at_first), 0).r;
    return (first_turn == float(side) ? area_at(uint(back), uint(ahead)) : 0.0) +
           (last_turn == float(side) ? area_at(uint(ahead), uint(back)) : 0.0);
}
#endif
