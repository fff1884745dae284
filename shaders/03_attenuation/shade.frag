// Lights a fragment.
#include "common/material.glsl"
#include "03_attenuation/lighting.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
layout(location = 4) flat in uint item;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

void main() {
    MaterialData material = materials[material_index];
    Surface surface = Surface(normalize(world_normal), normalize(view.eye - world_position), material.shininess);
    Lit lit = light_surface(surface, world_position);
    vec3 radiance = diffuse_color(material, uv) * (lit.diffuse + ambient) + material.specular * lit.specular +
                    material.emissive;
    color = vec4(min(radiance, 65504.0), 1.0);  // the largest number that the target holds
}
