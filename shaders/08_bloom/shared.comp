// Weighted neighbours along a line, each texel of which a workgroup reads once.
#include "08_bloom/blur_line.glsl"

layout(local_size_x = 256) in;

void main() {
    line_number = int(gl_WorkGroupID.y);
    int start = threads * int(gl_WorkGroupID.x);
    vec3 sum = blur_line(start, step_now.taps - 1);
    int i = start + int(gl_LocalInvocationIndex);
    ivec2 texel = step_now.direction.x == 1 ? ivec2(i, line_number) : ivec2(line_number, i);
    if (!is_outside(texel)) put(texel, sum);
}
