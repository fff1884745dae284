// SMAA's shapes (J. Jimenez et al., "SMAA: enhanced subpixel morphological antialiasing", 2012), by lists and distances:
// staircases of single steps, and ends at which edges across begin on both sides.
#include "13_mlaa/line_weight.glsl"
#include "13_mlaa/staircase.glsl"

const int least_steps = 2;  // of a staircase: a single one is a turn of some line

bool is_staircase(Staircase s) { return s.back > 0 && s.back + s.ahead - 1 >= least_steps; }

vec4 weights_of(ivec2 pixel) {
    // Above the edge of a step, or below it: the outline is the staircase, whatever lines its edges are.
    for (int i = 0; i < 2; ++i) {
        Staircase here = staircase_at(pixel, i == 0), above = staircase_at(pixel - ivec2(0, 1), i == 0);
        bool is_above = is_staircase(here), is_below = is_staircase(above);
        if (is_above || is_below) return vec4(0.0, 0.0, is_below ? corner_below(above) : 0.0, is_above ? corner_above(here) : 0.0);
    }
    return vec4(crossed_line_weight(pixel - ivec2(1, 0), false, 1), crossed_line_weight(pixel, false, -1),
                crossed_line_weight(pixel - ivec2(0, 1), true, 1), crossed_line_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
