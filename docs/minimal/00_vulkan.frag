#version 460
// [shader]
layout(location = 0) in vec3 color;  // interpolated between the three vertices
layout(location = 0) out vec4 result;

void main() {
    result = vec4(color, 1.0);
}
// [/shader]
