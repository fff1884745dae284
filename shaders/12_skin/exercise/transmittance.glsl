// Exercise 12.transmittance: what of the light behind an ear comes through.
// Until you fill it in, nothing does.
#include "12_skin/profile.h"

// [transmittance]
// J. Jimenez, D. Whelan, V. Sundstedt and D. Gutierrez, "Real-Time Realistic Skin Translucency", IEEE CG&A 30(4), 2010:
// through thickness_mm of skin comes the sum over the six Gaussians of skin_weight[i] * exp(-s² / v), s the thickness and v
// skin_variance_mm2[i]: 1 for 0 mm in every channel, and red goes farthest. The thickness comes from a shadow map, whose
// texels are not where the surface is: it may be a little below 0, and then counts as 0.
// [/transmittance]
vec3 transmittance(float thickness_mm) { return vec3(0.0); }
