// Exercise 04.nearest_on_lamp: the point that stands for a whole lamp in a highlight.
// Starter: the middle of the lamp; every lamp looks like a point.

// [nearest_on_lamp]
// A lamp is a ball of `radius` about `middle`, seen from a surface point at the origin; the
// mirrored ray runs from the origin along `mirrored`, a unit vector. Returns the point of the
// ball that is nearest to the ray. Where the ray passes through the ball, return the point of
// the ray that is nearest to the middle. A ray has no other side: if the lamp lies behind it,
// the ray's nearest point is the origin. `radius` is 0 or more, and smaller than the distance
// of the middle.
// [/nearest_on_lamp]
vec3 nearest_on_lamp(vec3 middle, float radius, vec3 mirrored) {
    return middle;
}
