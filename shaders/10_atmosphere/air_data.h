// A planet's air, as shaders and the processor read it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// Metres and 1/m. Three kinds of particles, each with its own density over height: exp(-height / scale height) for the
// molecules and the dust, a tent for the layer that only absorbs (ozone).
struct Air {
    vec3 rayleigh;          // scattering of the molecules at the ground, red, green and blue
    float rayleigh_height;  // their scale height; 0: there are none
    vec3 mie;               // scattering of the dust at the ground
    float mie_height;
    vec3 mie_extinction;              // and its total extinction
    float mie_g;                      // of its phase function
    vec3 layer;                       // absorption in the middle of the layer
    float layer_center, layer_width;  // the middle's height; from there down and up to nothing
    float radius;                     // of the ground
    float top;                        // height above which there is no air
    vec3 sun;                         // the sun's irradiance of a facing surface, outside of the air
    float sun_rad;                    // half of the angle that its disc fills
    vec3 ground;                      // albedo of the ground
};

// A straight way through the air.
struct Path {
    float height;     // of its start
    float slope;      // cosine of the angle between it and straight up, at its start
    float sun;        // cosine of the angle between the sun and straight up, there
    float cos_angle;  // cosine of the angle between it and the sun
    float way;        // how long it is
};

// Light and transmittance along a path.
struct Along {
    vec3 light;          // inscattered light
    vec3 transmittance;  // of light from the path's end
};

#ifndef __cplusplus
layout(scalar) uniform AirBlock { Air air; };
#endif

END_SHARED
