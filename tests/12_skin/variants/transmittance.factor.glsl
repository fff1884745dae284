// wrong: transmittance(
#include "12_skin/gaussian_profile.glsl"
vec3 transmittance(float thickness_mm) { return gaussian_profile(max(thickness_mm, 0.0)); }
