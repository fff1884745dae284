// Exercise 06.box_is_out: boxes that lie outside of the view.
// Starter: no box is out: the picture is right, and every object is drawn.

// [box_is_out]
// True if all of a box lies behind a plane of the view volume. A point p is in front of the
// plane, or in it, where dot(plane.xyz, p) + plane.w >= 0. The box reaches half_size (0 or
// more) from its center along each axis; metres, world space. A box that the plane touches
// or cuts is not out: part of it may be seen. Two dot products are enough.
// [/box_is_out]
bool box_is_out(vec3 center, vec3 half_size, vec4 plane) {
    return false;
}
