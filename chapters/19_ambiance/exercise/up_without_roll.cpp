// Exercise 19.up_without_roll: which way is up after a turn of the camera.
// Starter: up is what it was: it leans into the view, and where the view reaches it the picture flips.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [up_without_roll]
// A camera looks along the unit vector `from`, with the unit vector `up` at a right angle to
// it. It turns to look along the unit vector `to`, by the shortest way: about the axis at right
// angles to both. Returns where that turn takes `up`, as a unit vector at a right angle to
// `to`.
//
// So the picture never rolls about the line of sight, not even where that passes the zenith. A
// turn by 180 degrees has no shortest way: if the length of from + to is below 1e-6, `up` stays
// as it is. Without a turn `up` stays as well. Right within 1e-9 if the angle between the two
// views is at most 180 degrees less 1e-3 radians.
// [/up_without_roll]
glm::dvec3 up_without_roll(glm::dvec3 up, glm::dvec3 /*from*/, glm::dvec3 /*to*/) { return up; }

}  // namespace lightwalk::exercise
