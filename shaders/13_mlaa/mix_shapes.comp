// SMAA's shapes (J. Jimenez et al., "SMAA: enhanced subpixel morphological antialiasing", 2012), by lists and distances:
// staircases of single steps, corners, ends at which edges across begin on both sides, and details of one pixel.
#include "13_mlaa/areas.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/lines.glsl"
#include "13_mlaa/staircases.glsl"

// How far the outline along a staircase of single steps stands above the line through the middles of its steps.

// In the middle between two edges that are twice as long as a step the outline changes sides: half a pixel above the steps'
// middles at one end, half below at the other. `at`: where along the staircase, in steps from the step's start; the middle
// of its edge below is 1/2, that of the edge across 1.
float staircase_height(Staircase s, float at) {
    ivec2 first = first_of(s), last = last_of(s), along = ivec2(s.way, 1), aside = ivec2(s.way, 0);
    // (where the end lies before the first step's start or beyond the last's end, and by how much the outline is higher)
    vec2 end = vec2(0.0), start = vec2(0.0);
    if (edge_before(first, s.way)) {
        if (edge_before(first - ivec2(0, 1), s.way)) start = vec2(0.25, 0.5);
    } else if (edge_below(first - aside)) start = vec2(-0.25, -0.5);
    if (edge_after(last, s.way)) {
        if (edge_after(last + ivec2(0, 1), s.way)) end = vec2(0.25, -0.5);
    } else if (edge_below(last + aside)) end = vec2(-0.25, 0.5);
    float from_start = float(s.back - 1) + at + start.x, to_end = float(s.ahead) - at + end.x;
    float half_way = 0.5 * (from_start + to_end);
    return start.y * max(0.0, 1.0 - from_start / half_way) + end.y * max(0.0, 1.0 - to_end / half_way);
}

// Above the edge a corner is cut off the pixel where the edge across before it stands, below it where that after it does;
// both legs of that triangle are half a pixel, more by the height or less by it.
float corner_above(Staircase s) {
    float leg = edge_before(s.step, s.way) ? 0.5 + staircase_height(s, 0.25) : 0.0;
    return 0.5 * leg * leg;
}
float corner_below(Staircase s) {
    float leg = edge_after(s.step, s.way) ? 0.5 - staircase_height(s, 0.75) : 0.0;
    return 0.5 * leg * leg;
}

// As line_weight.glsl, with more shapes: ends with edges on both sides, and corners.

uniform sampler2D crossings;  // by the crossing edges at both ends: the side to which the outline turns there

bool edge_across(ivec2 pixel, bool horizontal) { return horizontal ? edge_right(pixel) : edge_below(pixel); }
bool edge_along(ivec2 pixel, bool horizontal) { return horizontal ? edge_below(pixel) : edge_right(pixel); }

// Edges across the line at an end: 1 on the near side, 2 on the far side, 3 both. `before`: the near pixel; the end
// lies behind it.
int across_at(ivec2 before, ivec2 across, bool horizontal) {
    return int(edge_across(before, horizontal)) + 2 * int(edge_across(before + across, horizontal));
}

// At an end of a slanted line the edge across is one pixel long. If it goes on, two lines meet: a corner of the
// object itself, which a straight silhouette through both would cut off. It keeps a quarter of its weight, for round
// shapes. If all four edges meet behind its first pixel, it does not go on: another object begins there.
const float kept_at_corner = 0.25;
float corner_share(ivec2 before, ivec2 across, int side, bool horizontal) {
    ivec2 second = before + (side < 0 ? -across : across), next = side < 0 ? second : second + across;
    bool crossing = edge_along(second, horizontal) && edge_along(second + across.yx, horizontal);
    return edge_across(next, horizontal) && !crossing ? kept_at_corner : 1.0;
}

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

// A pixel that differs from three or four of its neighbours is a detail too small for lines to tell its shape, and each of
// those neighbours has a share of it. Least squares over seven scenes give 0.07 to 0.15 for a single pixel.
const float detail_share = 1.0 / 8.0;

// Of the neighbours on the left, on the right, above and below; 0 where it is no detail. A pixel with three such neighbours
// that touches another one with a corner, where all four edges meet, is a step of a thin line.
vec4 detail_weights(ivec2 pixel) {
    bvec2 own = edges_of(pixel), left = edges_of(pixel - ivec2(1, 0)), above = edges_of(pixel - ivec2(0, 1));
    vec4 sides = vec4(left.y, own.y, above.x, own.x);
    float count = dot(sides, vec4(1.0));
    if (count < 3.0) return vec4(0.0);
    bool touches = left.y && above.x && all(edges_of(pixel - 1)) || own.y && above.x && above.y && edge_below(pixel + ivec2(1, -1)) ||
                   left.y && own.x && left.x && edge_right(pixel + ivec2(-1, 1)) ||
                   own.y && own.x && edge_below(pixel + ivec2(1, 0)) && edge_right(pixel + ivec2(0, 1));
    return count == 3.0 && touches ? vec4(0.0) : detail_share * sides;
}

vec4 weights_of(ivec2 pixel) {
    vec4 of_detail = detail_weights(pixel);
    if (of_detail != vec4(0.0)) return of_detail;
    // Above the edge of a step, or below it: the outline is the staircase, regardless of its edges' lines.
    int way = 0;
    bool is_above = false, is_below = false;
    for (int i = 1; i >= -1 && way == 0; i -= 2) {
        is_above = is_staircase(pixel, i);
        is_below = is_staircase(pixel - ivec2(0, 1), i);
        if (is_above || is_below) way = i;
    }
    if (way != 0) {
        float below = is_below ? corner_below(staircase_at(pixel - ivec2(0, 1), way)) : 0.0;
        return vec4(0.0, 0.0, below, is_above ? corner_above(staircase_at(pixel, way)) : 0.0);
    }
    return vec4(shape_weight(pixel - ivec2(1, 0), false, 1), shape_weight(pixel, false, -1),
                shape_weight(pixel - ivec2(0, 1), true, 1), shape_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
