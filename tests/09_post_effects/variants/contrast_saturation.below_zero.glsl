// wrong: saturate_color(
#include "common/light.glsl"
vec3 contrast(vec3 color, float amount) { return amount == 0.0 ? vec3(0.18) : 0.18 * pow(max(color, 0.0) / 0.18, vec3(amount)); }
vec3 saturate_color(vec3 color, float amount) { return mix(vec3(luminance(color)), color, amount); }
