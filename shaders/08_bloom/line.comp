// Weighted neighbours along a line.
#include "08_bloom/step.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar) readonly buffer TapBuffer { vec2 taps[]; };

// [line]
void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (is_outside(texel)) return;
    vec2 middle = vec2(place_of(texel)) + 0.5, along = vec2(step_now.direction);
    vec3 sum = taps[step_now.first_tap].y * read(middle);
    for (int i = 1; i < step_now.taps; ++i) {
        vec2 tap = taps[step_now.first_tap + i];
        sum += tap.y * (read(middle + tap.x * along) + read(middle - tap.x * along));
    }
    put(texel, sum);
}
// [/line]
