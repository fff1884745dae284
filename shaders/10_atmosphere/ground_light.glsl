// What falls on the ground under the air of the module Atmosphere: on a surface that faces the sun, and on level ground from
// the sky. light_ground() of the module comes before.
#include "10_atmosphere/sun_closed.glsl"

layout(scalar) readonly buffer SkylightBuffer { vec3 skylight[]; };  // by the sun's cosine, skylight.h says which

vec3 sunlight_on(Place place) { return air.sun * sun_transmittance(place); }

vec3 skylight_on(Place place) {
    float at = clamp(0.5 + 0.5 * sign(place.sun) * sqrt(abs(place.sun)), 0.0, 1.0) * float(skylight.length() - 1);
    int i = min(int(at), skylight.length() - 2);
    return mix(skylight[i], skylight[i + 1], at - float(i));
}
