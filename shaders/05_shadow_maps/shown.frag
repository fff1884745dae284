// Views of the knob `show`, and shading by rays, in a fragment shader.
#include "05_shadow_maps/shown.glsl"

layout(location = 0) out vec4 color;

void main() { color = shown(gl_FragCoord); }
