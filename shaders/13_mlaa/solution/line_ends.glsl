// Solution of 13.line_ends.
#include "13_mlaa/edge_source.glsl"

bool edge_of(ivec2 pixel, bool below) { return below ? edge_below(pixel) : edge_right(pixel); }

// `before`: the near pixel behind which the end lies; `beyond`: the near pixel of the line, were it longer.
int turn(ivec2 before, ivec2 beyond, ivec2 across, bool horizontal) {
    if (edge_of(beyond, horizontal)) return 0;
    return int(edge_of(before + across, !horizontal)) - int(edge_of(before, !horizontal));
}

ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1), across = along.yx;
    return ivec2(turn(first - along, first - along, across, horizontal), turn(last, last + along, across, horizontal));
}
