// A level of the pyramid brought up to the one above: a tent, which hides the texels.
#define OF_A_LEVEL
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

// A 3×3 tent (1 2 1) on the coarser level: with linear filtering, two reads along each axis with the weights 3, 7, 5
// and 1 sixteenths.
const float near = -0.55, far = 11.0 / 12.0, near_weight = 0.625, far_weight = 0.375;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    vec2 middle = 0.5 * (vec2(place_of(texel)) + 0.5);
    vec2 side = 2.0 * vec2(texel & 1) - 1.0;  // where the next texel lies
    vec3 close = near_weight * read(middle + near * side) + far_weight * read(middle + vec2(far, near) * side);
    vec3 away = near_weight * read(middle + vec2(near, far) * side) + far_weight * read(middle + far * side);
    put(texel, near_weight * close + far_weight * away);
}
