// Vertex transform of solid casters: a shadow map needs no more than their depth.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"

void main() {
    vec3 world_position = position_to_world(instances[gl_InstanceIndex].model, vertices[gl_VertexIndex].position);
    gl_Position = world_to_clip(view.view_projection, world_position);
}
