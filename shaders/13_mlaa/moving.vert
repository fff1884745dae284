// Where a vertex is, and where it was in the frame before.
#include "01_obj/transform.glsl"
#include "common/mesh_input.glsl"

layout(scalar) readonly buffer VertexBeforeBuffer { Vertex vertices_before[]; };
layout(scalar) readonly buffer InstanceBeforeBuffer { Instance instances_before[]; };
layout(scalar) uniform FromToBlock { mat4 now, before; } from_to;  // without the shifts within a pixel
layout(location = 0) out vec4 clip_now;
layout(location = 1) out vec4 clip_before;

void main() {
    vec3 now = position_to_world(instances[gl_InstanceIndex].model, vertices[gl_VertexIndex].position);
    vec3 before = position_to_world(instances_before[gl_InstanceIndex].model, vertices_before[gl_VertexIndex].position);
    clip_now = world_to_clip(from_to.now, now);
    clip_before = world_to_clip(from_to.before, before);
    gl_Position = world_to_clip(view.view_projection, now);
}
