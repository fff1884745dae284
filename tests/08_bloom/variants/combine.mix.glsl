// right
#include "08_bloom/finite_light.glsl"
vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes) {
    radiance = finite_light(radiance);
    if (mixes) return finite_light(mix(radiance, spread, strength));
    return min(radiance + strength * spread, 65504.0);
}
