// Exercise 14.box_project: a cube of the surroundings that is right away from its middle.
// Until you fill it in, the surroundings are taken for infinitely far away, and a room's reflections move with the camera.

// [box_project]
// A cube was drawn from `center`. The room around it is a box with corners `lower` and `upper` (metres, world space, along the
// axes), in which `position` lies. A ray from `position` along `direction` (any length above 0) hits a wall: the result is
// the direction from `center` to that place, any length above 0, by which the cube is to be looked up. A component of
// `direction` may be 0: the ray meets neither of these two walls, and GLSL says nothing of a division by 0. Where `position` lies
// outside the box and the ray leads away from it, take t = 0: the place itself. Where the place is `center` itself, the
// result is `direction`.
// [/box_project]
vec3 box_project(vec3 position, vec3 direction, vec3 lower, vec3 upper, vec3 center) {
    return direction;
}
