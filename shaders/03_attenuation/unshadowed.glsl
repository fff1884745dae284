// Lights without shadows.

vec3 light_visibility(uint light, vec3 position, vec3 facing, vec3 plane, vec3 to_light) { return vec3(1.0); }
