// Solution of 08.bright_pass.
#include "common/light.glsl"
#include "08_bloom/soft_knee.glsl"

vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    vec3 light = finite_light(radiance);
    float l = luminance(light);
    return l > 0.0 ? light * (soft_knee(l, threshold, knee) / l) : vec3(0.0);
}
