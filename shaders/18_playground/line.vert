// A segment as a strip of pixels of constant width.
#include "common/structs.h"
#include "18_playground/mark_data.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer LineBuffer { MarkSegment lines[]; };
layout(location = 0) flat out vec4 color;

void main() {
    MarkSegment line = lines[gl_VertexIndex / 6];
    int corner = gl_VertexIndex % 6;
    vec4 a = view.view_projection * vec4(line.from, 1.0), b = view.view_projection * vec4(line.to, 1.0);
    color = vec4(line.color, line.alpha);
    // Cut off in front of the camera: behind it the division by w would turn the line around.
    const float least = 1e-4;
    if (a.w < least && b.w < least) {
        gl_Position = vec4(2.0, 2.0, 0.5, 1.0);
        return;
    }
    if (a.w < least) a = mix(b, a, (b.w - least) / (b.w - a.w));
    if (b.w < least) b = mix(a, b, (a.w - least) / (a.w - b.w));
    vec2 from = a.xy / a.w, to = b.xy / b.w, along = (to - from) * view.size;
    vec2 across = length(along) > 1e-6 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
    bool at_end = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
    gl_Position = vec4((at_end ? to : from) + side * across * line.width_px / view.size, 0.5, 1.0);
}
