// Weighted neighbours along a line, each texel of which a workgroup reads once.
#include "08_bloom/step.glsl"
#include "08_bloom/blur_line.glsl"

layout(local_size_x = 256) in;
layout(scalar) readonly buffer TapBuffer { vec2 taps[]; };
int line_number;

// Interface of blur_line.glsl.
vec3 texel(int i) {
    vec2 along = vec2(step_now.direction);
    return read((float(i) + 0.5) * along + (float(line_number) + 0.5) * along.yx);
}

float weight_at(int distance) { return taps[step_now.first_tap + distance].y; }

void main() {
    line_number = int(gl_WorkGroupID.y);
    int start = threads * int(gl_WorkGroupID.x);
    vec3 sum = blur_line(start, step_now.taps - 1);
    int i = start + int(gl_LocalInvocationIndex);
    ivec2 texel = step_now.direction.x == 1 ? ivec2(i, line_number) : ivec2(line_number, i);
    if (!is_outside(texel)) put(texel, sum);
}
