// MLAA: shares of a pixel by the lines of edges on its four sides.
#include "13_mlaa/areas.glsl"
#include "13_mlaa/line_ends.glsl"
#include "13_mlaa/lines.glsl"

// How much of a pixel the outline along one line of edges gives to the pixel on the other side.

// `near` is the pixel above or on the left of the edge; `side` is -1 where the share of that pixel is asked for, 1 where
// that of the one across.
float line_weight(ivec2 near, bool horizontal, int side) {
    EdgeLine l = line_at(near, horizontal);
    if (l.back == 0) return 0.0;
    ivec2 ends = line_ends(first_of(l), last_of(l), horizontal);
    go_beyond_border(l, ends);
    return (ends.x == side ? area_at(l.back, l.ahead) : 0.0) + (ends.y == side ? area_at(l.ahead, l.back) : 0.0);
}

vec4 weights_of(ivec2 pixel) {
    return vec4(line_weight(pixel - ivec2(1, 0), false, 1), line_weight(pixel, false, -1),
                line_weight(pixel - ivec2(0, 1), true, 1), line_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
