// A rectangle of one colour, alpha and tint.
#include "common/put_surface.glsl"

layout(location = 0) flat in vec4 quad_color;
layout(location = 1) flat in vec3 quad_tint;

void main() { put_surface(quad_color.rgb, quad_color.a, quad_tint); }
