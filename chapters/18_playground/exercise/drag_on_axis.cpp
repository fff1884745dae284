// Exercise 18.drag_on_axis: how far along an axis the mouse is.
// As it stands the arrow stays where it is.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [drag_on_axis]
// An arrow of the gizmo begins at `pivot` and goes along `axis` (unit length); `ray` is that of the mouse (unit length).
// Two lines in space rarely meet. Returns where on the axis the point is that is closest to the ray's line, in metres from
// the pivot, negative behind it. With w = ray.origin - pivot, b = dot(axis, ray.direction) and s = 1 - b² that is
//
//     (dot(axis, w) - b dot(ray.direction, w)) / s.
//
// s is the square of the sine of the angle between the two lines. Seen from its end an axis is a point: at 10° a pixel of
// the mouse moves the object 5.8 pixels' worth of metres, at 1° 57, and at 0° the quotient is 0 / 0. Below 10° the object
// has to slow down instead: divide by the square of the sine of 10° where s is less. The result is then a finite number for
// every ray, and 0 where the lines are parallel. Near there s and the numerator are small differences of large numbers.
// With d the ray's direction they are also
//
//     s = dot(c, c),  numerator = dot(c, cross(w, d)),  c = cross(axis, d),
//
// which loses no digits (Lagrange's identity).
// [/drag_on_axis]
float drag_on_axis(const PickRay& ray, glm::vec3 pivot, glm::vec3 axis) {
    (void)ray, (void)pivot, (void)axis;
    return 0.0f;
}

}  // namespace lightwalk::exercise
