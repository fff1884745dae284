// The module Preetham for shaders: its knobs, and with them a sky and a sun for a picture.
#include "10_atmosphere/preetham.glsl"

layout(scalar) uniform PreethamBlock {
    float turbidity, exposure, sun;
} preetham;

// Linear light of the sky in a direction of unit length, times the module's exposure.
vec3 sky_light(vec3 direction, vec3 to_sun) {
    return preetham.exposure * preetham_sky(direction, to_sun, preetham.turbidity);
}

// The sun's irradiance of a facing surface, of the same scale: a white matt one reflects sun_light / pi of it.
vec3 sun_light(vec3 to_sun) {
    return preetham.exposure * preetham.sun * preetham_sunlight(to_sun, preetham.turbidity);
}
