// SMAA's shapes (J. Jimenez et al., "SMAA: enhanced subpixel morphological antialiasing", 2012), by lists and distances:
// staircases of single steps, corners, ends at which edges across begin on both sides, and details of one pixel.
#include "13_mlaa/shape_weight.glsl"
#include "13_mlaa/staircase.glsl"

// [detail]
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
// [/detail]

vec4 weights_of(ivec2 pixel) {
    vec4 of_detail = detail_weights(pixel);
    if (of_detail != vec4(0.0)) return of_detail;
    // Above the edge of a step, or below it: the outline is the staircase, whatever lines its edges are.
    for (int way = 1; way >= -1; way -= 2) {
        Staircase here = staircase_at(pixel, way > 0), above = staircase_at(pixel - ivec2(0, 1), way > 0);
        bool is_above = is_staircase(here), is_below = is_staircase(above);
        if (is_above || is_below)
            return vec4(0.0, 0.0, is_below ? corner_below(above) : 0.0, is_above ? corner_above(here) : 0.0);
    }
    return vec4(shape_weight(pixel - ivec2(1, 0), false, 1), shape_weight(pixel, false, -1),
                shape_weight(pixel - ivec2(0, 1), true, 1), shape_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
