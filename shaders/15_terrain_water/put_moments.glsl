// Moment-based transparency, first pass: the moments of the absorbance along each pixel's ray. C. Muenstermann, S. Krumpen,
// R. Klein and C. Peters, "Moment-Based Order-Independent Transparency", I3D 2018.
#include "15_terrain_water/moment_depth.glsl"

layout(location = 0) out vec4 of_depth;  // added up: absorbance times depth, its square, cube and fourth power
layout(location = 1) out float of_all;   // added up: absorbance

void put_surface(vec3 radiance, float alpha) {
    float z = moment_depth();
    of_all = absorbance_of(alpha);
    of_depth = of_all * vec4(z, z * z, z * z * z, z * z * z * z);
}
