// For test_scene*.cpp: the item counted from 1, its material's red times its texture, the light that comes from +z, and
// whether it shows its front.
#include "common/material.glsl"

layout(location = 0) in vec3 world_normal;
layout(location = 1) flat in uint item;
layout(location = 0) out vec4 color;

void main() {
    color = vec4(float(item) + 1.0, diffuse_color(materials[item], vec2(0.5), 0.0).r, max(normalize(world_normal).z, 0.0),
                 gl_FrontFacing ? 1.0 : 0.0);
}
