// As line_weight.glsl, with more shapes: ends with edges on both sides, and corners.
#include "13_mlaa/areas.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/lines.glsl"

uniform sampler2D crossings;  // by what stands across at an end and at the other: to which side the outline turns there

bool edge_across(ivec2 pixel, bool horizontal) { return horizontal ? edge_right(pixel) : edge_below(pixel); }
bool edge_along(ivec2 pixel, bool horizontal) { return horizontal ? edge_below(pixel) : edge_right(pixel); }

// What stands across the line at an end: 1 an edge on the near side, 2 on the far side, 3 both. `before`: the near pixel
// behind which the end lies.
int across_at(ivec2 before, ivec2 across, bool horizontal) {
    return int(edge_across(before, horizontal)) + 2 * int(edge_across(before + across, horizontal));
}

// [corner]
// At an end of a slanted line the edge across is one pixel long. Where it goes on, two lines meet: a corner of the thing
// itself, which a straight silhouette through both would cut off. It keeps a quarter of its weight, for what is round.
// Where all four edges meet behind its first pixel, it does not go on: another thing begins there.
const float kept_at_corner = 0.25;
float corner_share(ivec2 before, ivec2 across, int side, bool horizontal) {
    ivec2 second = before + (side < 0 ? -across : across), next = side < 0 ? second : second + across;
    bool crossing = edge_along(second, horizontal) && edge_along(second + across.yx, horizontal);
    return edge_across(next, horizontal) && !crossing ? kept_at_corner : 1.0;
}
// [/corner]

float shape_weight(ivec2 near, bool horizontal, int side) {
    EdgeLine l = line_at(near, horizontal);
    if (l.back == 0) return 0.0;
    ivec2 before = first_of(l) - l.along, last = last_of(l), across = l.along.yx;
    int at_first = across_at(before, across, horizontal), at_last = across_at(last, across, horizontal);
    vec2 kept = vec2(corner_share(before, across, side, horizontal), corner_share(last, across, side, horizontal));

    // Where the line goes on, it was not followed any farther, unless all four edges meet.
    if (at_first < 3 && edge_along(before, horizontal)) at_first = 0;
    if (at_last < 3 && edge_along(last + l.along, horizontal)) at_last = 0;
    ivec2 turns = ivec2(texelFetch(crossings, ivec2(at_first, at_last), 0).r, texelFetch(crossings, ivec2(at_last, at_first), 0).r);
    go_beyond_border(l, turns);
    if (l.back + l.ahead == 2) return 0.0;  // a step of another line
    return (turns.x == side ? area_at(l.back, l.ahead) * kept.x : 0.0) + (turns.y == side ? area_at(l.ahead, l.back) * kept.y : 0.0);
}
