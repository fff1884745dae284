// Exercise 19.arc_length: a camera that moves at an even speed.
// Starter: parameters are used as they are, and the camera is fast where keys are far apart.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [arc_length]
// `points` are points of a curve at n + 1 evenly spaced parameters 0, 1/n, 2/n ... 1 (n is at
// least 1). Returns the parameter from 0 to 1 at which `share` of the length of the curve is
// covered, where the curve counts as straight between two neighbouring points, and the
// parameter as rising evenly along each of those lines.
//
// A share of 0 or less gives 0, one of 1 or more gives 1. A curve may rest: between equal
// points no length is covered. If a share between 0 and 1 is reached at several parameters for
// this reason, return the smallest of them. On a curve of length 0 return the share itself.
// Right within 1e-9.
//
// It is called for every frame with a few hundred points.
// [/arc_length]
double arc_length(const std::vector<glm::dvec3>& /*points*/, double share) { return glm::clamp(share, 0.0, 1.0); }

}  // namespace lightwalk::exercise
