// Exercise 05.sphere_shadow: the shadow of a sphere without a map.
// Until you fill it in, there is none.

// [sphere_shadow_hard]
// 1 where the light is seen, 0 where the sphere stands in its way. `to_center` goes from the point to the sphere's middle,
// in metres; `to_light` has unit length. How far does the line towards the light pass from the sphere's middle? And a
// sphere behind the point, seen from the light, shadows nothing.
// [/sphere_shadow_hard]
float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    return 1.0;
}

// [sphere_shadow_power]
// The same with a soft edge that knows nothing of the light's size: 1 at the edge of the shadow and outside of it; going
// in, 1 minus a power of how deep the line is inside the sphere, |distance - radius|, in units of `width`; 0 from `width`
// on. `width` (metres) and `power` are above 0.
// [/sphere_shadow_power]
float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    return 1.0;
}

// [hidden_share]
// Which share of a sun's disc, of radius 1, the disc of a planet hides, 0 to 1. `radius` is the planet's, in radii of the
// sun, from 0 to 1e6. `gap` goes from the sun's middle to the nearest point of the planet's edge, in the same unit: 1 where
// the discs just touch, 0 where the edge goes through the sun's middle, below 0 beyond it, and never below -radius. A
// planet that looks smaller than the sun hides its own area at most.
// The area that two discs share is made of two segments, one on either side of the chord through the points where their
// edges cross. With a planet that looks hundreds of times as large as the sun, what rounding loses of its area is more than
// what of it lies in front of the sun: there its edge is straight, or nearly. 0.002 of the share is near enough.
// [/hidden_share]
float hidden_share(float radius, float gap) {
    return 0.0;
}
