// Varyings of surfaces, loaded or displaced. A dispatch over a visibility buffer has variables of these names.
#include "01_obj/transform.glsl"
#include "common/structs.h"
#include "04_surface_maps/plain_draw.glsl"

#ifndef SEEN
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec3 world_tangent;
layout(location = 3) out float handedness;
layout(location = 4) out vec2 metres_per_uv;
layout(location = 5) out vec2 uv;
layout(location = 6) flat out uint material_index;
layout(location = 7) flat out uint item;  // which of the scene's items
layout(location = 8) out float cos_uv;
#if MAPS_SECOND_UVS
layout(location = 9) out vec2 second_uv;
#endif
#if MAPS_COLORS
layout(location = 10) out vec4 vertex_color;
#endif
invariant gl_Position;                    // the depth pass and the shading pass agree to the last bit
#endif

#if MAPS_SECOND_UVS
layout(scalar) readonly buffer SecondUvBuffer { vec2 second_uvs[]; };
#endif
#if MAPS_COLORS
layout(scalar) readonly buffer ColorBuffer { vec4 vertex_colors[]; };
#endif

// Optional attributes, interpolated over a triangle; `shares` add up to 1.
void set_rare_varyings(uvec3 vertices_of, vec3 shares) {
#if MAPS_SECOND_UVS
    second_uv = mat3x2(second_uvs[vertices_of.x], second_uvs[vertices_of.y], second_uvs[vertices_of.z]) * shares;
#endif
#if MAPS_COLORS
    vertex_color =
        mat3x4(vertex_colors[vertices_of.x], vertex_colors[vertices_of.y], vertex_colors[vertices_of.z]) * shares;
#endif
}

void set_varyings(Vertex vertex, TangentFrame frame, Instance instance) {
    world_position = position_to_world(instance.model, vertex.position);
    world_normal = normal_to_world(instance.normal_matrix, vertex.normal);
    // A tangent lies in the surface and goes with it: the model matrix itself, not the normals' one.
    vec3 tangent = mat3(instance.model) * frame.tangent;
    vec3 across = frame.handedness * cross(vertex.normal, frame.tangent);
    vec3 along_v = frame.cos_uv * frame.tangent + sqrt(max(1.0 - frame.cos_uv * frame.cos_uv, 0.0)) * across;
    vec3 bitangent = mat3(instance.model) * along_v;
    world_tangent = tangent / max(length(tangent), 1e-20);
    metres_per_uv = frame.metres_per_uv * vec2(length(tangent), length(bitangent));
    cos_uv = dot(world_tangent, bitangent / max(length(bitangent), 1e-20));  // a stretched instance shears, too
    // A mirrored instance turns the frame inside out.
    handedness = frame.handedness * (determinant(mat3(instance.model)) < 0.0 ? -1.0 : 1.0);
    uv = vertex.uv;
    material_index = instance.material;
    item = instance.material;  // each has its own
}
