// wrong: contrast(
#include "common/light.glsl"
vec3 contrast(vec3 color, float amount) { return amount == 0.0 ? vec3(0.5) : 0.5 * pow(max(color, 0.0) / 0.5, vec3(amount)); }
vec3 saturate_color(vec3 color, float amount) { return max(mix(vec3(luminance(color)), color, amount), 0.0); }
