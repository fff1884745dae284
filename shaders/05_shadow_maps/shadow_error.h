// Kinds of shadow errors: one definition for the picture that shows them and for the study that counts them.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint SHADOW_RIGHT = 0u;
const uint SHADOW_ACNE = 1u;
const uint SHADOW_PETER_PANNING = 2u;
const uint SHADOW_LEAK = 3u;
const uint SHADOW_EDGE = 4u;

// [shadow_error]
// The truth at a point and around it: over points of the surface's tangent plane that a filter at this point may
// average.
struct ShadowTruth {
    float visibility;   // at the point, 0 to 1
    float least, most;  // of the visibilities around it, its own among them
    float blocker_m;    // along the way to the middle of the lamp to the nearest thing in between; below 0: none
};

// `shown` is a method's visibility, `tolerance` the accepted error, `contact_m` the distance of a blocker within
// which its shadow ought to touch it. On a surface that faces the light:
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
// [/shadow_error]

END_SHARED
