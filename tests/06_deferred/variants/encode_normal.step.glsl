// right
vec2 encode_normal(vec3 normal) {
    normal /= abs(normal.x) + abs(normal.y) + abs(normal.z);
    vec2 signs = 2.0 * step(vec2(0.0), normal.xy) - 1.0;
    return normal.z < 0.0 ? signs - signs * abs(normal.yx) : normal.xy;
}
