// right
#include "08_bloom/finite_light.glsl"
#include "08_bloom/luminance.glsl"
#include "08_bloom/soft_knee.glsl"
vec3 bright_pass(vec3 radiance, float threshold, float knee) {
    radiance = finite_light(radiance);
    float l = luminance(radiance);
    return radiance * soft_knee(l, threshold, knee) / max(l, 1e-20);
}
