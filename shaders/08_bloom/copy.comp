// One read and one write of a texel: the least that a level of any pyramid costs. It blurs nothing.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    put(texel, read((vec2(place_of(texel)) + 0.5) * step_now.spread));
}
