// wrong: vignette(
float vignette(vec2 uv, float aspect, float strength, float power) {
    vec2 d = (uv - 0.5) * vec2(aspect, 1.0);
    float r = length(d) / 0.5;
    return power == 0.0 ? 1.0 - strength : 1.0 - strength * pow(r, power);
}
