// right
#include "common/light.glsl"
vec3 contrast(vec3 color, float amount) {
    vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = color[i] > 0.0 ? exp2(log2(0.18) + amount * (log2(color[i]) - log2(0.18))) : amount == 0.0 ? 0.18 : 0.0;
    return result;
}
vec3 saturate_color(vec3 color, float amount) { float grey = luminance(color); return max(grey + amount * (color - grey), 0.0); }
