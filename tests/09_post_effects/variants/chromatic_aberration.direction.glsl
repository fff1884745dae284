// wrong: normali
vec2 aberrated(vec2 uv, float shift) {
    vec2 a = uv - 0.5;
    float r2 = 2.0 * dot(a, a);
    return 0.5 + normalize(a) * length(a) * (1.0 + shift * r2) / (1.0 + max(shift, 0.0));
}
