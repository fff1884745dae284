// right
vec3 decode_normal(vec2 code) {
    vec3 n = vec3(code, 1.0 - dot(abs(code), vec2(1.0)));
    float down = max(-n.z, 0.0);  // what folding takes off both
    n.x += n.x >= 0.0 ? -down : down;
    n.y += n.y >= 0.0 ? -down : down;
    return n * inversesqrt(dot(n, n));
}
