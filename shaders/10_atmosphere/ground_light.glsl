// What falls on the ground under the air of the module Atmosphere: on a surface that faces the sun, and on level ground from
// the sky. light_ground() of the module comes before.
#include "10_atmosphere/skylight.glsl"
#include "10_atmosphere/sun_closed.glsl"

vec3 sunlight_on(Place place) { return air.sun * sun_transmittance(place); }
