// Exercise 13.reproject: where the surface in a pixel was in the frame before.
// Starter: nothing has moved.

// [reproject]
// `at` is a position in this frame in pixels: (0, 0) is the upper left corner of the
// picture, `size` the lower right one. `depth` is what the depth buffer holds there: 1 at
// the near plane, 0 at infinity. `to_before` maps clip space of this frame, with w = 1,
// to clip space of the frame before, in both of which x and y go from -1 to 1 (y down).
//
// Returns (x, y, w): the position of the same surface in the frame before, in pixels, and
// the w of its clip space there. A surface that was not in front of the camera then has a
// w of 0 or less: return (0, 0, 0) for it, and do not divide.
// [/reproject]
vec3 reproject(vec2 at, float depth, vec2 size, mat4 to_before) {
    return vec3(at, 1.0);
}
