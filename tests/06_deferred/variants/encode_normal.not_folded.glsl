// wrong: expected (
vec2 encode_normal(vec3 normal) { return normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z)); }
