// A rectangle of one colour and alpha.
#include "common/put_surface.glsl"

layout(location = 0) flat in vec4 quad_color;

void main() { put_surface(quad_color.rgb, quad_color.a); }
