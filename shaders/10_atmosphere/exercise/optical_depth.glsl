// Exercise 10.optical_depth: the optical depth of a ray out of the air, without a loop.
// Starter: it is that of a flat planet, without a horizon.

// [optical_depth]
// Returns the integral of exp(-h / scale_height), h the height above the ground, along
// a ray that starts at `height` and never ends: the equivalent length in metres of air
// as dense as at the ground. `slope` is the cosine of the angle between the ray and
// straight up. Height (0 or more), radius and scale_height are in metres. For a
// scale_height of 0 the result is 0.
//
// Slope of 0 or more: with X = (radius + height) / scale_height and
// x = sqrt(X / 2) * slope, the integral is
// scale_height * exp(-height / scale_height) * sqrt(pi X / 2) * s(x), with the fit of
// Smith and Smith
//
//     s(x) = (1.0606963 + 0.55643831 x) / (1.0619896 + 1.7245609 x + x^2)   for x up to 8
//     s(x) = 0.56498823 / (0.06651874 + x)                                  above
//
// Slope below 0: the fit does not hold. The ray descends to a lowest point, where it is
// level, and rises again. The whole straight line through the lowest point has twice
// the integral of a level ray from there. Subtract from it the part behind the start,
// which is a ray from the start in the opposite direction, with the slope -slope.
//
// The lowest point lies (radius + height) * (1 - sqrt(1 - slope^2)) below the start.
// Rewrite this without the difference, which has no digits left for a small slope. If
// it lies below the ground, use a height of 0.
// [/optical_depth]
float optical_depth(float height, float slope, float radius, float scale_height) {
    return scale_height > 0.0 ? scale_height * exp(-height / scale_height) / max(slope, 0.1) : 0.0;
}
