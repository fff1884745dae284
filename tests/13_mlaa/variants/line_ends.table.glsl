// right
#include "13_mlaa/edge_source.glsl"
int code(ivec2 before, ivec2 beyond, bool horizontal) {
    bool near = horizontal ? edge_right(before) : edge_below(before);
    bool far = horizontal ? edge_right(before + ivec2(0, 1)) : edge_below(before + ivec2(1, 0));
    bool more = horizontal ? edge_below(beyond) : edge_right(beyond);
    return int(near) + 2 * int(far) + 4 * int(more);
}
ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal) {
    const int sides[] = int[](0, -1, 1, 0, 0, 0, 0, 0);
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
    int a = code(first - along, first - along, horizontal), b = code(last, last + along, horizontal);
    return ivec2(a == 7 ? -sides[b] : sides[a], b == 7 ? -sides[a] : sides[b]);
}
