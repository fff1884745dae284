// wrong: vignette(
float vignette(vec2 uv, float aspect, float strength, float power) {
    float r = length(uv - 0.5) / length(vec2(0.5));
    return power == 0.0 ? 1.0 - strength : 1.0 - strength * pow(r, power);
}
