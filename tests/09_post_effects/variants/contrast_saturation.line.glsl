// wrong: contrast(
#include "common/light.glsl"
vec3 contrast(vec3 color, float amount) { return max(0.18 + amount * (color - 0.18), 0.0); }
vec3 saturate_color(vec3 color, float amount) { return max(mix(vec3(luminance(color)), color, amount), 0.0); }
