// Exercise 17.ellipsoid_shadow: the shadow of a planet that is not round.
// As it stands the planet is a sphere, and Saturn's shadow falls 8% too far over its rings.
#include "05_shadow_maps/sphere_visibility.glsl"

// [ellipsoid_shadow]
// What share of the sun's disc is seen from `point` (metres, from the planet's centre; outside of it), 0 to 1. The planet is an
// ellipsoid: `radius` at the equator, (1 - flattening) * radius along `pole`, its axis of unit length. `to_sun` is the direction to
// the sun, unit length, whose disc fills an angle of 2 sun_rad. Chapter 05 knows the answer for a sphere:
//     sphere_visibility(vec3 to_center, float radius, vec3 to_light, float sun_rad)
// Stretched along the pole by 1 / (1 - flattening), the ellipsoid is a sphere of that radius, and a straight line stays
// one. Stretch what must be stretched. to_light must have unit length. The stretch turns the sun's round disc into an ellipse, which may
// be left out: the edge of the shadow stays where it is, its penumbra becomes up to 10% wider or narrower.
// [/ellipsoid_shadow]
float ellipsoid_shadow(vec3 point, vec3 pole, float radius, float flattening, vec3 to_sun, float sun_rad) {
    return sphere_visibility(-point, radius, to_sun, sun_rad);
}
