// Solution of 08.combine.
#include "common/light.glsl"

vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes) {
    vec3 light = finite_light(radiance);
    return finite_light((mixes ? 1.0 - strength : 1.0) * light + strength * spread);
}
