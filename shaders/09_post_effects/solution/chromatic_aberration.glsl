// Solution of 09.chromatic_aberration.
vec2 aberrated(vec2 uv, float shift) {
    vec2 away = uv - 0.5;
    float r2 = dot(away, away) / 0.5;
    return 0.5 + away * (1.0 + shift * r2) / (1.0 + max(shift, 0.0));
}
