// Stand-in shading of a mesh: bright sky above, warm ground below, darker towards the silhouette.
#include "common/material.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };

const vec3 sky = vec3(1.05, 1.08, 1.15);
const vec3 ground = vec3(0.13, 0.10, 0.09);
const vec3 up = normalize(vec3(0.45, 0.85, 0.30));

void main() {
    MaterialData material = materials[material_index];
    vec3 n = normalize(world_normal);
    vec3 v = normalize(view.eye - world_position);
    float facing = abs(dot(n, v));
    float brightness = 0.5 + 0.5 * dot(n, up);
    vec3 light = mix(ground, sky, brightness * brightness) * mix(0.3, 1.0, facing);
    vec3 shine = material.specular * pow(brightness * facing, 12.0);
    color = vec4(diffuse_color(material, uv, view.lod_bias) * light + shine + emitted_color(material), 1.0);
}
