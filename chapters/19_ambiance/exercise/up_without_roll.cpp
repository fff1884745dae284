// Exercise 19.up_without_roll: which way is up after a turn of the camera.
// As it stands up is what it was: it leans into the view, and where the view reaches it the picture flips.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [up_without_roll]
// A camera looks along the unit vector `from`, with the unit vector `up` at a right angle to it. It turns to look along
// the unit vector `to`, by the shortest way: about the axis at right angles to both. Returns where that turn takes `up`,
// as a unit vector at a right angle to `to`.
//
// So the picture never rolls about the line of sight, whatever that passes, the zenith too. A turn by 180 degrees has no
// shortest way: where from and to are within 1e-6 of opposite, `up` stays as it is. No turn at all changes nothing. Right
// within 1e-9 where they are at least 1e-3 from opposite.
// [/up_without_roll]
glm::dvec3 up_without_roll(glm::dvec3 up, glm::dvec3 /*from*/, glm::dvec3 /*to*/) { return up; }

}  // namespace lightwalk::exercise
