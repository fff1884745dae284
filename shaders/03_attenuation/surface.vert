// Vertex transform; invariant, so that depth and shading passes agree to the last bit.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint material;
layout(location = 4) flat out uint item;  // index of the draw call
invariant gl_Position;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    Instance instance = instances[gl_InstanceIndex];
    world_position = position_to_world(instance.model, vertex.position);
    world_normal = normal_to_world(instance.normal_matrix, vertex.normal);
    uv = vertex.uv;
    material = instance.material;
    item = gl_InstanceIndex;
    gl_Position = world_to_clip(view.view_projection, world_position);
}
