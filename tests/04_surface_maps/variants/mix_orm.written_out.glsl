// right
#include "04_surface_maps/mixed_material.glsl"

float overridden(float map, float override) {
    return override >= 0.0 ? override : map;
}

MixedMaterial mix_orm(vec3 base, float roughness, float metalness) {
    float r4 = pow(roughness, 4.0), exponent = r4 * (most_shininess + 2.0) < 2.0 ? most_shininess : 2.0 / r4 - 2.0;
    return MixedMaterial(base - metalness * base, 0.04 * (1.0 - metalness) + base * metalness, max(exponent, 0.0));
}
