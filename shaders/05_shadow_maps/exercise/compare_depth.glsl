// Exercise 05.compare_depth: whether light reaches a point.
// Starter: it always does.

// [compare_depth]
// The visibility of a point: 1 if it is lit, 0 if it is in shadow. `place` is the result of
// light_clip_position(). `stored` is the depth in the map at place.xy, that of the surface
// nearest to the light: 1 at the near plane and 0 at the far plane, and also 0 if the light
// sees nothing there. A point at exactly the stored depth is that surface itself, and lit.
// A point whose xy is outside 0 to 1 is not covered by the map, and lit too. place.z is
// compared whatever its value.
// [/compare_depth]
float compare_depth(vec3 place, float stored) {
    return 1.0;
}
