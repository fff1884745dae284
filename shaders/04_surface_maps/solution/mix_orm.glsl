// Solution of 04.mix_orm.
#include "common/structs.h"

float overridden(float map, float override) {
    return override >= 0.0 ? override : map;
}

// The exponent: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, section 5.2;
// alpha = roughness^2: B. Burley, "Physically Based Shading at Disney", 2012; 0.04: B. Karis, "Real Shading in Unreal
// Engine 4", 2013.
MixedMaterial mix_orm(vec3 base, float roughness, float metalness) {
    float alpha = roughness * roughness;
    float shininess = clamp(2.0 / max(alpha * alpha, 1e-8) - 2.0, 0.0, most_shininess);
    return MixedMaterial(base * (1.0 - metalness), mix(vec3(0.04), base, metalness), shininess);
}
