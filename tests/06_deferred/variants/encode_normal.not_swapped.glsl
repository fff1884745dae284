// wrong: expected (
vec2 encode_normal(vec3 normal) {
    vec2 e = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    if (normal.z >= 0.0) return e;
    return (1.0 - abs(e)) * vec2(e.x < 0.0 ? -1.0 : 1.0, e.y < 0.0 ? -1.0 : 1.0);
}
