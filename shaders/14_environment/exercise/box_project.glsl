// Exercise 14.box_project: a cube of the surroundings that is right away from its middle.
// Starter: the surroundings are treated as infinitely distant, and a room's reflections move with the camera.

// [box_project]
// A cube of the surroundings was drawn from `center`. The room around it is a box with the
// corners `lower` and `upper` (metres, world space, faces along the axes), in which
// `position` lies. A ray from `position` along `direction` (any length above 0)
// hits a wall of the box. Returns the direction from `center` to this point, of any length
// above 0: in this direction the cube is looked up.
//
// - A component of `direction` may be 0. The ray then meets neither of the two walls across
//   this axis; a division by 0 is undefined in GLSL.
// - By rounding, or where the room is no box, `position` may lie outside: beyond the wall of an
//   axis. If the ray leads farther away along that axis, use `position` itself instead of the
//   point on the wall. A ray from outside that leads through the box meets the wall by which
//   it leaves the box.
// - If the point is `center` itself, return `direction`.
// [/box_project]
vec3 box_project(vec3 position, vec3 direction, vec3 lower, vec3 upper, vec3 center) {
    return direction;
}
