// wrong: decode_normal(code
vec3 decode_normal(vec2 code) {
    vec3 n = vec3(code, 1.0 - abs(code.x) - abs(code.y));
    if (n.z < 0.0) {
        n.x = (1.0 - abs(n.y)) * (n.x < 0.0 ? -1.0 : 1.0);
        n.y = (1.0 - abs(n.x)) * (n.y < 0.0 ? -1.0 : 1.0);
    }
    return normalize(n);
}
