// wrong: saturate_color(
vec3 contrast(vec3 color, float amount) { return amount == 0.0 ? vec3(0.18) : 0.18 * pow(max(color, 0.0) / 0.18, vec3(amount)); }
vec3 saturate_color(vec3 color, float amount) { return max(mix(vec3((color.r + color.g + color.b) / 3.0), color, amount), 0.0); }
