// Solution of 13.line_ends.
#include "13_mlaa/edge_source.glsl"

const int touching = 2;  // instead of a side

bool edge_of(ivec2 pixel, bool below) { return below ? edge_below(pixel) : edge_right(pixel); }

// `before`: the near pixel behind which the end lies; `beyond`: the near pixel of the line, were it longer.
int turn(ivec2 before, ivec2 beyond, ivec2 across, bool horizontal) {
    bool near = edge_of(before, !horizontal), far = edge_of(before + across, !horizontal);
    if (edge_of(beyond, horizontal)) return near && far ? touching : 0;
    return int(far) - int(near);
}

int opposite(int side) { return side == touching ? 0 : -side; }

ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1), across = along.yx;
    int back = turn(first - along, first - along, across, horizontal), ahead = turn(last, last + along, across, horizontal);
    return ivec2(back == touching ? opposite(ahead) : back, ahead == touching ? opposite(back) : ahead);
}
