// M. Bjørge, "Bandwidth-efficient rendering", 2015: half of the middle, an eighth of each corner.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    vec2 middle = 2.0 * vec2(place_of(texel)) + 1.0;
    float s = step_now.spread;
    vec3 corners = read(middle + vec2(-s, -s)) + read(middle + vec2(s, -s)) + read(middle + vec2(-s, s)) + read(middle + vec2(s, s));
    put(texel, 0.5 * read(middle) + 0.125 * corners);
}
