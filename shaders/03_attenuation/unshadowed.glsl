// Light that nothing stands in the way of.

// [light_visibility]
float light_visibility(uint light, vec3 position, vec3 facing, vec3 to_light) { return 1.0; }
// [/light_visibility]
