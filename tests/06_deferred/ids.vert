// Places a vertex; its fragments get the number of the object.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"

layout(location = 0) flat out uint object;

void main() {
    Instance instance = instances[gl_InstanceIndex];
    object = instance.material + 1u;
    gl_Position = world_to_clip(view.view_projection, position_to_world(instance.model, vertices[gl_VertexIndex].position));
}
