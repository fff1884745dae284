// Exercise 10.optical_depth: how much air lies on the way out, without a loop.
// Until you fill it in, it is as if the planet were flat, and nothing near the horizon.

// [optical_depth]
// The integral of exp(-h / scale_height) along a ray from `height` out to infinity, in metres: what lies on its way, in
// metres of air as dense as at the ground. `slope` is the cosine of the angle between the ray and straight up. With
// X = (radius + height) / scale_height and x = sqrt(X / 2) * slope, for a slope of 0 or more it is
// scale_height exp(-height / scale_height) sqrt(pi X / 2) s(x), with Smith and Smith's fit
//     s(x) = (1.0606963 + 0.55643831 x) / (1.0619896 + 1.7245609 x + x²)  for x up to 8,  else 0.56498823 / (0.06651874 + x).
// A ray with a slope below 0 sinks to its lowest point, where it is level, and rises again: both halves of the level ray
// through that point, less what lies behind the start. The lowest point lies (radius + height) (1 - sin) below the start,
// which must not be computed as such a difference; where it lies below the ground, as if it lay on it. Heights and radius in
// metres, height 0 or more. A scale_height of 0 gives 0.
// [/optical_depth]
float optical_depth(float height, float slope, float radius, float scale_height) {
    return scale_height > 0.0 ? scale_height * exp(-height / scale_height) / max(slope, 0.1) : 0.0;
}
