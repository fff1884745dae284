// Vertex transform, with lighting for Gouraud shading.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"
#include "02_lambert_phong/shading.glsl"

#if METHOD == METHOD_GOURAUD
layout(scalar) readonly buffer MaterialBuffer { MaterialData materials[]; };
layout(location = 4) out vec3 lit_diffuse;
layout(location = 5) out vec3 lit_specular;
#endif
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint material;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    Instance instance = instances[gl_InstanceIndex];
    world_position = position_to_world(instance.model, vertex.position);
    world_normal = normal_to_world(instance.normal_matrix, vertex.normal);
    uv = vertex.uv;
    material = instance.material;
    gl_Position = world_to_clip(view.view_projection, world_position);
#if METHOD == METHOD_GOURAUD
    Lit lit = light_surface(world_position, world_normal, view.eye, materials[instance.material].shininess);
    lit_diffuse = lit.diffuse;
    lit_specular = lit.specular;
#endif
}
