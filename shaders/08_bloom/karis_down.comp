// A level of the pyramid that does not flicker, and does not keep the light.
#include "08_bloom/level_source.glsl"
#include "common/light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

// B. Karis, "Tone mapping", 2013: each square's mean counts the less the brighter it is. Light is lost.
vec3 weighed(ivec2 at) {
    const vec3 squares[] = vec3[](vec3(0, 0, 0.5), vec3(-1, -1, 0.125), vec3(1, -1, 0.125), vec3(-1, 1, 0.125),
                                  vec3(1, 1, 0.125));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 5; ++i) {
        vec2 middle = squares[i].xy;
        vec3 mean = 0.25 * (above(at, middle + vec2(-1, -1)) + above(at, middle + vec2(1, -1)) +
                            above(at, middle + vec2(-1, 1)) + above(at, middle + vec2(1, 1)));
        sum += squares[i].z / (1.0 + luminance(mean)) * vec4(mean, 1.0);
    }
    return sum.rgb / sum.a;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (!is_outside(texel)) put(texel, weighed(place_of(texel)));
}
