// What is no skin, shaded as it is drawn.
#include "12_skin/matt_shading.glsl"

layout(location = 0) out vec4 color;

void main() { color = vec4(matt_radiance(), 1.0); }
