// wrong: bright_pass(radiance =
#include "08_bloom/finite_light.glsl"
#include "08_bloom/luminance.glsl"
#include "08_bloom/soft_knee.glsl"
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    vec3 l = finite_light(radiance);
    return vec3(soft_knee(l.r, threshold, knee), soft_knee(l.g, threshold, knee), soft_knee(l.b, threshold, knee));
}
