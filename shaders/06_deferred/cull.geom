// Back-face culling in a geometry shader, of surfaces with one side. LEFT_OUT: emits the culled triangles instead.
#include "04_surface_maps/plain_draw.glsl"
#include "common/structs.h"
#include "06_deferred/cull_back_face.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

layout(scalar) readonly buffer InstanceBuffer { Instance instances[]; };
layout(scalar) uniform ViewBlock { CameraView view; };

layout(location = 0) in vec3 position_in[];
layout(location = 1) in vec3 normal_in[];
layout(location = 2) in vec3 tangent_in[];
layout(location = 3) in float handedness_in[];
layout(location = 4) in vec2 metres_per_uv_in[];
layout(location = 5) in vec2 uv_in[];
layout(location = 6) flat in uint material_in[];
layout(location = 7) flat in uint item_in[];
layout(location = 8) in float cos_uv_in[];
#if MAPS_SECOND_UVS
layout(location = 9) in vec2 second_uv_in[];
layout(location = 9) out vec2 second_uv;
#endif
#if MAPS_COLORS
layout(location = 10) in vec4 vertex_color_in[];
layout(location = 10) out vec4 vertex_color;
#endif

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec3 world_tangent;
layout(location = 3) out float handedness;
layout(location = 4) out vec2 metres_per_uv;
layout(location = 5) out vec2 uv;
layout(location = 6) flat out uint material_index;
layout(location = 7) flat out uint item;
layout(location = 8) out float cos_uv;
invariant gl_Position;

void main() {
    bool mirrored = determinant(mat3(instances[item_in[0]].model)) < 0.0;
    bool culled = is_back_face(position_in[0] - view.eye, position_in[1] - view.eye, position_in[2] - view.eye, mirrored);
#if MAPS_TWO_SIDED
    culled = false;
#endif
#ifdef LEFT_OUT
    culled = !culled;
#endif
    if (culled && gl_PrimitiveIDIn >= 0) return;  // always true: lavapipe 22 crashes on shaders that cannot emit
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        world_position = position_in[i];
        world_normal = normal_in[i];
        world_tangent = tangent_in[i];
        handedness = handedness_in[i];
        metres_per_uv = metres_per_uv_in[i];
        uv = uv_in[i];
        material_index = material_in[i];
        item = item_in[i];
        cos_uv = cos_uv_in[i];
#if MAPS_SECOND_UVS
        second_uv = second_uv_in[i];
#endif
#if MAPS_COLORS
        vertex_color = vertex_color_in[i];
#endif
        EmitVertex();
    }
    EndPrimitive();
}
