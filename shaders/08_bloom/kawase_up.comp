// M. Bjørge, "Bandwidth-efficient rendering", 2015: eight reads on a diamond, those on its sides with twice the weight.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    vec2 middle = 0.5 * (vec2(place_of(texel)) + 0.5);
    float s = step_now.spread, h = 0.5 * s;
    vec3 tips = read(middle + vec2(-s, 0)) + read(middle + vec2(s, 0)) + read(middle + vec2(0, -s)) + read(middle + vec2(0, s));
    vec3 sides = read(middle + vec2(-h, -h)) + read(middle + vec2(h, -h)) + read(middle + vec2(-h, h)) + read(middle + vec2(h, h));
    put(texel, (tips + 2.0 * sides) / 12.0);
}
