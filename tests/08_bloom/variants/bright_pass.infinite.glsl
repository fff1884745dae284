// wrong: inf
#include "08_bloom/finite_light.glsl"
#include "08_bloom/luminance.glsl"
#include "08_bloom/soft_knee.glsl"
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    float l = luminance(radiance);
    return l > 0.0 ? radiance * soft_knee(l, threshold, knee) / l : vec3(0.0);
}
