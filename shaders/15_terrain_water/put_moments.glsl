// Moment-based transparency, first pass: the moments of the absorbance along each pixel's ray. C. Muenstermann, S. Krumpen,
// R. Klein and C. Peters, "Moment-Based Order-Independent Transparency", I3D 2018.
#include "15_terrain_water/moment_depth.glsl"
#include "15_terrain_water/tint.glsl"

layout(location = 0) out vec4 of_depth;  // added up: absorbance times depth, its square, cube and fourth power
#if TRANSPARENCY_METHOD == TRANSPARENCY_METHOD_MOMENTS6
layout(location = 1) out vec4 of_all;  // added up: absorbance, that times the fifth power and the sixth
#else
layout(location = 1) out float of_all;  // added up: absorbance
#endif
layout(location = 2) out vec4 tints;  // multiplied

void put_surface(vec3 radiance, float alpha, vec3 tint) {
    float z = moment_depth(), square = z * z, absorbance = absorbance_of(alpha);
    of_depth = absorbance * vec4(z, square, square * z, square * square);
#if TRANSPARENCY_METHOD == TRANSPARENCY_METHOD_MOMENTS6
    of_all = absorbance * vec4(1.0, square * square * z, square * square * square, 0.0);
#else
    of_all = absorbance;
#endif
    tints = vec4(tint_through(vec3(1.0), 0.0, used_tint(tint)), 1.0);
}
