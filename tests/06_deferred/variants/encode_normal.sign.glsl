// wrong: expected (-1, 0.5)
vec2 encode_normal(vec3 normal) {
    vec2 e = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    return normal.z >= 0.0 ? e : (1.0 - abs(e.yx)) * sign(e);
}
