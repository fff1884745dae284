#version 460
// [shader]
struct Vertex {
    vec4 position;  // clip space: x and y from -1 to 1, y down
    vec4 color;     // linear light
};
layout(std430, set = 0, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(push_constant) uniform Push { float angle_rad; };
layout(location = 0) out vec3 color;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    mat2 rotation = mat2(cos(angle_rad), sin(angle_rad), -sin(angle_rad), cos(angle_rad));
    gl_Position = vec4(rotation * vertex.position.xy, vertex.position.zw);
    color = vertex.color.rgb;
}
// [/shader]
