// SMAA's shapes (J. Jimenez et al., "SMAA: enhanced subpixel morphological antialiasing", 2012), by lists and distances:
// staircases of single steps, corners, and ends at which edges across begin on both sides.
#include "13_mlaa/shape_weight.glsl"
#include "13_mlaa/staircase.glsl"

// On all four sides of the pixel.
bool is_lone(ivec2 pixel) {
    return edge_right(pixel) && edge_below(pixel) && edge_right(pixel - ivec2(1, 0)) && edge_below(pixel - ivec2(0, 1));
}

vec4 weights_of(ivec2 pixel) {
    // Above the edge of a step, or below it: the outline is the staircase, whatever lines its edges are.
    for (int way = 1; way >= -1; way -= 2) {
        Staircase here = staircase_at(pixel, way > 0), above = staircase_at(pixel - ivec2(0, 1), way > 0);
        bool is_above = is_staircase(here), is_below = is_staircase(above);
        if ((is_above || is_below) && !is_lone(pixel))
            return vec4(0.0, 0.0, is_below ? corner_below(above) : 0.0, is_above ? corner_above(here) : 0.0);
    }
    return vec4(shape_weight(pixel - ivec2(1, 0), false, 1), shape_weight(pixel, false, -1),
                shape_weight(pixel - ivec2(0, 1), true, 1), shape_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
