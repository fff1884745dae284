// wrong: pow(0, 0)
float vignette(vec2 uv, float aspect, float strength, float power) {
    vec2 d = (uv - 0.5) * vec2(aspect, 1.0);
    return 1.0 - strength * pow(length(d) / length(vec2(0.5 * aspect, 0.5)), power);
}
