// wrong: combine(radiance =
#include "08_bloom/finite_light.glsl"
vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes) {
    return (mixes ? 1.0 - strength : 1.0) * radiance + strength * spread;
}
