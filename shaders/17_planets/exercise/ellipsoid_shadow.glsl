// Exercise 17.ellipsoid_shadow: the shadow of a planet that is not round.
// Starter: the planet is a sphere, and Saturn's shadow falls 8% too far over its rings.
#include "05_shadow_maps/sphere_visibility.glsl"

// [ellipsoid_shadow]
// Returns the fraction of the sun's disc, 0 to 1, that is visible from `point` (metres, from
// the planet's centre, outside the planet) past the planet. The planet is an ellipsoid with
// the radius `radius` at the equator and (1 - flattening) * radius along `pole`, its axis, of
// unit length. `to_sun` is the direction to the sun, of unit length; the sun's disc has the
// angular radius sun_rad. Chapter 05 solves the problem for a sphere:
//
//     sphere_visibility(vec3 to_center, float radius, vec3 to_light, float sun_rad)
//
// Stretched along the pole by 1 / (1 - flattening), the ellipsoid becomes a sphere of the
// radius `radius`, and straight lines stay straight. Decide which of the arguments have to
// be stretched; sphere_visibility() takes unit vectors. The stretch also turns the sun's
// disc into an ellipse. Ignore this: it makes the penumbra wider or narrower by up to the
// flattening. Tolerance: 0.07.
// [/ellipsoid_shadow]
float ellipsoid_shadow(vec3 point, vec3 pole, float radius, float flattening, vec3 to_sun, float sun_rad) {
    return sphere_visibility(-point, radius, to_sun, sun_rad);
}
