// wrong: divides 2 by 0
#include "04_surface_maps/mixed_material.glsl"

float overridden(float map, float override) {
    return override >= 0.0 ? override : map;
}

MixedMaterial mix_orm(vec3 base, float roughness, float metalness) {
    float alpha = roughness * roughness;
    float shininess = min(2.0 / (alpha * alpha) - 2.0, most_shininess);
    return MixedMaterial(base * (1.0 - metalness), mix(vec3(0.04), base, metalness), shininess);
}
