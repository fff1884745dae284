// One read and one write of a texel: the least that a level of any pyramid costs. It blurs nothing.
#include "08_bloom/step.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    vec2 scale = vec2(textureSize(from, 0)) / vec2(imageSize(into));
    put(texel, read((vec2(texel) + 0.5) * scale));
}
