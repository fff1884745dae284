// Pictures of the knob SHOW, and the picture by rays, as surfaces are drawn.
#include "05_shadow_maps/shown.glsl"

layout(location = 0) out vec4 color;

void main() { color = shown(gl_FragCoord); }
