// Edges that much stronger ones beside them hide (J. Jimenez et al., 2012, section 4.1: local contrast), from the colours that
// a workgroup has read.
#include "13_mlaa/lab_distance.glsl"

const int seen_side = 19;  // of the square of pixels from (-1, -1) to (17, 17)
shared float seen[3][seen_side * seen_side];

int seen_slot(ivec2 place) { return (place.y + 1) * seen_side + place.x + 1; }
void see_lab(ivec2 place, vec3 lab) {
    int slot = seen_slot(place);
    seen[0][slot] = lab.x, seen[1][slot] = lab.y, seen[2][slot] = lab.z;
}
vec3 seen_lab(ivec2 place) {
    int slot = seen_slot(place);
    return vec3(seen[0][slot], seen[1][slot], seen[2][slot]);
}

// The pixels around the square of sixteen that 13.lab_edges has not asked for, or need not have: number `i` of 35.
const int unseen_pixels = 35;
ivec2 unseen_place(int i) {
    return i < 16 ? ivec2(17, i) : i < 32 ? ivec2(i - 16, 17) : i == 32 ? ivec2(-1, 16) : i == 33 ? ivec2(16, -1) : ivec2(16, 16);
}

const float hidden_by = 2.0;  // as often as strong

// [strong_edges]
// The edge between a pixel and the next one is seen where none of those around it is more than twice as strong: along the
// same axis before and behind it, and across it at either of its two pixels.
bool is_seen(ivec2 pixel, ivec2 along) {
    ivec2 across = along.yx, next = pixel + along;
    vec3 here = seen_lab(pixel), there = seen_lab(next);
    float strongest = max(lab_distance(here, seen_lab(pixel - along)), lab_distance(there, seen_lab(next + along)));
    for (int side = -1; side <= 1; side += 2) {
        strongest = max(strongest, lab_distance(here, seen_lab(pixel + side * across)));
        strongest = max(strongest, lab_distance(there, seen_lab(next + side * across)));
    }
    return hidden_by * lab_distance(here, there) >= strongest;
}
// [/strong_edges]
