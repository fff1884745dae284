// Exercise 12.transmittance: the light that passes through a thin part, such as an ear.
// Starter: no light does.
#include "12_skin/profile.h"

// [transmittance]
// Returns the fraction of light that passes through thickness_mm of skin, for red,
// green and blue (J. Jimenez, D. Whelan, V. Sundstedt and D. Gutierrez, 2010). Each of
// the six Gaussians falls off with the thickness s as exp(-s^2 / v),
// v = skin_variance_mm2[i], and counts with skin_weight[i]. Note the exponent: it is
// not the one of 12.gaussian_profile.
//
// Decide which factor, if any, precedes the exponential: through a thickness of 0 all
// light passes, 1 in every channel. The thickness comes from a shadow map, whose texels
// do not lie exactly on the surface, and may be slightly below 0; it then counts as 0.
// [/transmittance]
vec3 transmittance(float thickness_mm) { return vec3(0.0); }
