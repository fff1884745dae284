// wrong: normali
float vignette(vec2 uv, float aspect, float strength, float power) {
    vec2 d = (uv - 0.5) * vec2(aspect, 1.0);
    float r = dot(normalize(d), d) / length(vec2(0.5 * aspect, 0.5));
    return power == 0.0 ? 1.0 - strength : 1.0 - strength * pow(max(r, 0.0), power);
}
