// Exercise 05.compare_depth: whether light reaches a point.
// Until you fill it in, it always does.

// [compare_depth]
// 1 where the point is lit, 0 where it is in shadow. `place` is what light_clip_position says; `stored` is the depth that
// the map holds there: that of the surface nearest to the light, 1 at the near plane and 0 at the far one, and 0 where
// the light sees nothing. A point at the very depth that is stored is the surface itself, and lit. So is every point that
// the map knows nothing of: whose xy is outside 0 to 1. Any z is compared.
// [/compare_depth]
float compare_depth(vec3 place, float stored) {
    return 1.0;
}
