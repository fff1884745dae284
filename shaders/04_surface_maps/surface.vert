// Vertex transform with the tangent frame.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"
#include "04_surface_maps/surface_varyings.glsl"

layout(scalar) readonly buffer TangentBuffer { TangentFrame tangents[]; };

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    set_varyings(vertex, tangents[gl_VertexIndex], instances[gl_InstanceIndex]);
    set_rare_varyings(uvec3(gl_VertexIndex), vec3(1.0, 0.0, 0.0));
    gl_Position = world_to_clip(view.view_projection, world_position);
}
