// Exercise 04.mix_orm: Blinn–Phong parameters from roughness and metalness.
// Starter: everything is matt and nothing is metal.
#include "common/structs.h"

// [overridden]
// The override if it is 0 or more (so 0 is an override too), and the value from the map
// otherwise.
// [/overridden]
float overridden(float map, float override) {
    return map;
}

// [mix_orm]
// The diffuse colour, specular colour and specular exponent of a material. `base` is the
// specular colour of a metal and the diffuse colour of any other material, linear. With
// metalness m from 0 to 1, diffuse = base (1 - m) and specular = 0.04 (1 - m) + base m.
// With alpha = roughness squared, the exponent is 2 / alpha^2 - 2, which is 0 for roughness
// 1. It is at most most_shininess, also for roughness 0, where the formula divides by 0.
// [/mix_orm]
MixedMaterial mix_orm(vec3 base, float roughness, float metalness) {
    return MixedMaterial(base, vec3(0.0), 0.0);
}
