// A rectangle given by its corners.
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform QuadBlock {
    vec3 corners[4];
    vec4 color;
} quad;

layout(location = 0) flat out vec4 quad_color;

void main() {
    const int corners[6] = int[](0, 1, 2, 0, 2, 3);
    quad_color = quad.color;
    gl_Position = view.view_projection * vec4(quad.corners[corners[gl_VertexIndex]], 1.0);
}
