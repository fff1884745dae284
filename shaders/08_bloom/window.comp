// A double loop over a square of neighbours, as a blur is first taught.
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar) readonly buffer TapBuffer { vec2 taps[]; };

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    int radius = step_now.taps - 1;
    vec3 sum = vec3(0.0);
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            sum += taps[step_now.first_tap + abs(x)].y * taps[step_now.first_tap + abs(y)].y *
                   read(vec2(texel) + 0.5 + vec2(x, y));
    put(texel, sum);
}
