// The ground, shaded as it is drawn.
#include "11_fractals/terrain_color.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) out vec4 color;

vec4 look_up(sampler2D map, vec2 uv, vec2 across, vec2 down) { return texture(map, uv); }

void main() { color = vec4(terrain_color(position, vec3(0.0), vec3(0.0)), 1.0); }
