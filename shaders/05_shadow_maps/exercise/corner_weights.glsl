// Exercise 05.corner_weights: the weights with which a pixel of a visibility buffer sees the corners of its triangle.
// Starter: each pixel sees the middle of its triangle; triangles have one colour each.

// [corner_weights]
// The weights with which a pixel sees the corners `a`, `b` and `c` of its triangle. The corners
// are in clip space, (x, y, depth, w), before the division by w; `place` is the pixel's point on
// the screen, from -1 to 1. The mean of the corners with these weights lies at `place`, that is,
// its x and y are place times its w; and the weights add up to 1. So whatever is linear along the
// triangle in space can be interpolated with them. Place may lie outside of the triangle, and
// corners behind the camera, where w is below 0. Where no weights do that, or many do, as for a
// triangle that is seen from its edge, return (1, 0, 0).
// [/corner_weights]
vec3 corner_weights(vec4 a, vec4 b, vec4 c, vec2 place) {
    return vec3(1.0 / 3.0);
}
