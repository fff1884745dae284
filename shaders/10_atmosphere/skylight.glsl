// Light that the sky of the module Atmosphere sheds on level ground.
#include "10_atmosphere/air.glsl"

layout(scalar) readonly buffer SkylightBuffer { vec3 skylight[]; };  // by the sun's cosine, skylight.h says which

vec3 skylight_on(Place place) {
    float at = clamp(0.5 + 0.5 * sign(place.sun) * sqrt(abs(place.sun)), 0.0, 1.0) * float(skylight.length() - 1);
    int i = min(int(at), skylight.length() - 2);
    return mix(skylight[i], skylight[i + 1], at - float(i));
}
