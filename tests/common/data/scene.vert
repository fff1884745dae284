// For test_scene*.cpp: places a vertex and says which item it belongs to.
#include "common/mesh_input.glsl"

layout(location = 0) out vec3 world_normal;
layout(location = 1) flat out uint item;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    Instance instance = instances[gl_InstanceIndex];
    world_normal = instance.normal_matrix * vertex.normal;
    item = gl_InstanceIndex;
    gl_Position = view.view_projection * (instance.model * vec4(vertex.position, 1.0));
}
