// right
#include "09_post_effects/picture_source.glsl"
vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < taps; ++i) {
        float share = taps > 1 ? strength * float(i) / float(taps - 1) : 0.0;
        sum += picture(mix(uv, centre, share));
    }
    return sum / float(taps);
}
