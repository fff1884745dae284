// Solution of 09.vignette.
float vignette(vec2 uv, float aspect, float strength, float power) {
    vec2 corner = vec2(0.5 * aspect, 0.5);
    float r = length((uv - 0.5) * vec2(aspect, 1.0)) / length(corner);
    return 1.0 - strength * (power == 0.0 ? 1.0 : pow(r, power));
}
