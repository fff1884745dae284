// right
vec2 aberrated(vec2 uv, float shift) {
    float r2 = 2.0 * dot(uv - 0.5, uv - 0.5), whole = shift > 0.0 ? 1.0 + shift : 1.0;
    return mix(vec2(0.5), uv, (1.0 + shift * r2) / whole);
}
