// Fragment shading, per pixel or from interpolated vertex light.
#include "common/material.glsl"
#include "02_lambert_phong/shading.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
#if METHOD == METHOD_GOURAUD
layout(location = 4) in vec3 lit_diffuse;
layout(location = 5) in vec3 lit_specular;
#endif
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
#if AMBIENT
layout(scalar) uniform AmbientBlock { vec3 ambient; };
#endif

void main() {
    MaterialData material = materials[material_index];
#if METHOD == METHOD_GOURAUD
    Lit lit = Lit(lit_diffuse, lit_specular);
#else
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
    Lit lit = light_surface(world_position, normal, view.eye, material.shininess);
#endif
#if AMBIENT
    lit.diffuse += ambient;
#endif
    color = vec4(diffuse_color(material, uv, view.lod_bias) * lit.diffuse + material.specular * lit.specular +
                     emitted_color(material), 1.0);
}
