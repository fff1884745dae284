// Kinds of shadow errors, for the picture that shows them and the study that counts them.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint SHADOW_RIGHT = 0u;
const uint SHADOW_ACNE = 1u;
const uint SHADOW_PETER_PANNING = 2u;
const uint SHADOW_LEAK = 3u;
const uint SHADOW_EDGE = 4u;

// Ray-traced visibility at a point and over the part of its tangent plane within the filter's reach.
struct ShadowTruth {
    float visibility;   // visibility at the point, 0 to 1
    float least, most;  // minimum and maximum around it, its own included
    float blocker_m;    // distance to the nearest blocker towards the lamp's centre, metres; below 0: none
};

// `shown`: a method's visibility; `tolerance`: accepted error; `contact_m`: blocker distance within which a shadow must
// touch its caster. On a surface facing the light:
//   acne           darker than the truth, and the truth is fully lit all around: only the surface itself can be why
//   peter-panning  lighter than the truth, which is fully dark all around, and the blocker is nearer than contact_m
//   leak           the same, and the blocker is farther away
//   edge           wrong, and the truth around is neither: an edge in another place, or softer or harder than it is
SHARED_FUNCTION uint shadow_error(float shown, ShadowTruth truth, float tolerance, float contact_m) {
    if (abs(shown - truth.visibility) <= tolerance) return SHADOW_RIGHT;
    if (truth.least >= 1.0f) return SHADOW_ACNE;
    if (truth.most > 0.0f) return SHADOW_EDGE;
    return truth.blocker_m >= 0.0f && truth.blocker_m < contact_m ? SHADOW_PETER_PANNING : SHADOW_LEAK;
}

END_SHARED
