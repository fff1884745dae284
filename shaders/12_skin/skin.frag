// Skin, shaded as it is drawn.
#include "12_skin/skin_shading.glsl"

layout(location = 0) out vec4 color;
#if DIFFUSE == BY_SCREEN
layout(location = 1) out vec4 light_out;  // to be blurred
layout(location = 2) out vec4 after_out;  // by what it is then multiplied
#endif

void main() {
    vec4 light, after;
    shade_skin(color, light, after);
#if DIFFUSE == BY_SCREEN
    light_out = light, after_out = after;
#endif
}
