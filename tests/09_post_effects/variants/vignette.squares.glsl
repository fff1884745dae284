// right
float vignette(vec2 uv, float aspect, float strength, float power) {
    vec2 d = (uv - 0.5) * vec2(aspect, 1.0);
    float r2 = dot(d, d) / (0.25 * aspect * aspect + 0.25);
    if (power == 0.0) return 1.0 - strength;
    return 1.0 - strength * pow(r2, 0.5 * power);
}
