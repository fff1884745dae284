// wrong: divides
#include "08_bloom/finite_light.glsl"
#include "08_bloom/luminance.glsl"
#include "08_bloom/soft_knee.glsl"
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    vec3 light = finite_light(radiance);
    float l = luminance(light);
    return light * soft_knee(l, threshold, knee) / l;
}
