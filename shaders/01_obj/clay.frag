// A mesh without lights yet: a bright sky above, a warm ground below, and a little darker where the surface turns away
// from the eye, so that its shape can be read. Chapter 02 puts reflection in its place.
#include "common/material.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };

const vec3 sky = vec3(0.95, 1.0, 1.08);
const vec3 ground = vec3(0.22, 0.18, 0.15);

void main() {
    MaterialData material = materials[material_index];
    vec3 n = normalize(world_normal);
    vec3 v = normalize(view.eye - world_position);
    float facing = abs(dot(n, v));
    vec3 light = mix(ground, sky, 0.5 + 0.5 * n.y) * mix(0.35, 1.0, facing);
    vec3 shine = material.specular * pow(max(n.y, 0.0) * facing, 8.0);
    color = vec4(diffuse_color(material, uv) * light + shine + material.emissive, 1.0);
}
