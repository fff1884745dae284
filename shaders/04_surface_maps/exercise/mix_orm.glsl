// Exercise 04.mix_orm: from roughness and metalness to what Blinn–Phong takes.
// Until you fill it in, everything is matt and no metal.
#include "common/structs.h"

// [overridden]
// The map's number, or the override instead where that is 0 or more.
// [/overridden]
float overridden(float map, float override) {
    return map;
}

// [mix_orm]
// `base` is a metal's specular colour and anything else's diffuse colour, linear. With metalness m from 0 to 1:
// diffuse = base (1 - m), specular = 0.04 (1 - m) + base m. With alpha = roughness squared, the exponent is
// 2 / alpha^2 - 2, from 0 for roughness 1, and at most most_shininess: also for roughness 0.
// [/mix_orm]
MixedMaterial mix_orm(vec3 base, float roughness, float metalness) {
    return MixedMaterial(base, vec3(0.0), 0.0);
}
