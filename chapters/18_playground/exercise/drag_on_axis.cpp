// Exercise 18.drag_on_axis: how far along an axis the mouse is.
// Starter: the arrow stays where it is.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [drag_on_axis]
// An arrow of the gizmo begins at `pivot` and goes along `axis` (unit length); `ray` is that of
// the mouse (unit length). In space, two lines rarely meet. Returns the point on the axis that
// is closest to the line of the ray, in metres from the pivot, negative behind it. With w =
// ray.origin - pivot, d = ray.direction, b = dot(axis, d) and s = 1 - b² it is
//
//     (dot(axis, w) - b dot(d, w)) / s.
//
// s is the square of the sine of the angle between the two lines. An axis seen from its end is
// a point. At 10° a movement of the mouse by one pixel moves the object by 5.8 times the length
// of a pixel at its distance, at 1° by 57 times, and at 0° the quotient is 0 / 0. Below 10° the
// object has to slow down instead: where s is less than the square of the sine of 10°, divide
// by that square. The result is then a finite number for every ray, and 0 where the lines are
// parallel.
//
// Where the lines are nearly parallel, s and the numerator are small differences of large
// numbers. Lagrange's identity gives the same values without this loss of digits:
//
//     s = dot(c, c),  numerator = dot(c, cross(w, d)),  c = cross(axis, d).
//
// Tolerance: 2e-4 m plus 2e-4 of the result, and 4 mm more for a pivot 1 km from the origin.
// [/drag_on_axis]
float drag_on_axis(const PickRay& ray, glm::vec3 pivot, glm::vec3 axis) {
    (void)ray, (void)pivot, (void)axis;
    return 0.0f;
}

}  // namespace lightwalk::exercise
