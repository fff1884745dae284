// wrong: divides
#include "09_post_effects/picture_source.glsl"
vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < taps; ++i) sum += picture(mix(uv, centre, strength * (float(i) / float(taps - 1))));
    return sum / float(taps);
}
