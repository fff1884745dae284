// Solution of 09.radial_blur.
#include "09_post_effects/picture_source.glsl"

vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps) {
    vec3 sum = picture(uv);
    for (int i = 1; i < taps; ++i) sum += picture(uv + (strength * float(i) / float(taps - 1)) * (centre - uv));
    return sum / float(taps);
}
