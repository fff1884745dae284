// Rectangles given by their corners.
#include "common/structs.h"

struct Quad {
    vec3 corners[4];
    vec4 color;
    vec3 tint;
};
layout(scalar) readonly buffer QuadBuffer { Quad quads[]; };
layout(scalar) uniform ViewBlock { CameraView view; };

layout(location = 0) flat out vec4 quad_color;
layout(location = 1) flat out vec3 quad_tint;

void main() {
    const int corners[6] = int[](0, 1, 2, 0, 2, 3);
    quad_color = quads[gl_InstanceIndex].color;
    quad_tint = quads[gl_InstanceIndex].tint;
    gl_Position = view.view_projection * vec4(quads[gl_InstanceIndex].corners[corners[gl_VertexIndex]], 1.0);
}
