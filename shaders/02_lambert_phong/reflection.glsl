// Reflection of one light by a surface, for every chapter from here on.
#include "02_lambert_phong/blinn_phong_light.glsl"

Reflected reflect_light(Surface surface, vec3 to_light) { return reflect_by_blinn_phong(surface, to_light); }
