// Local contrast: edges that much stronger ones beside them hide (J. Jimenez et al., 2012, section 4.1).
#include "13_mlaa/lab_distance.glsl"

vec3 colour_at(ivec2 pixel);  // the includer's, in CIELAB

const float hidden_by = 2.0;  // as often as strong

// The edge between a pixel and the next one is seen where none of those around it is more than twice as strong: along the
// same axis before and behind it, and across it at either of its two pixels.
bool is_seen(ivec2 pixel, ivec2 along) {
    ivec2 across = along.yx, next = pixel + along;
    vec3 here = colour_at(pixel), there = colour_at(next);
    float strongest = max(lab_distance(here, colour_at(pixel - along)), lab_distance(there, colour_at(next + along)));
    for (int side = -1; side <= 1; side += 2) {
        strongest = max(strongest, lab_distance(here, colour_at(pixel + side * across)));
        strongest = max(strongest, lab_distance(there, colour_at(next + side * across)));
    }
    return hidden_by * lab_distance(here, there) >= strongest;
}
