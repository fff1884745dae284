// right
float level_of(float h, float r) { return sqrt(max(h, 0.0)) * sqrt(2.0 * r + h); }
vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    float b = (radius + height) * slope, c = (top - height) * (2.0 * radius + height + top), d = sqrt(max(b * b + c, 0.0));
    float way = b > 0.0 ? c / (d + b) : d - b;
    float a = level_of(height, radius), least = top - height, range = a + level_of(top, radius) - least;
    vec2 at = vec2(range > 0.0 ? (way - least) / range : 0.0, a / level_of(top, radius));
    return 0.5 / size + clamp(at, 0.0, 1.0) * (1.0 - 1.0 / size);
}
vec2 table_place(vec2 uv, float radius, float top, vec2 size) {
    vec2 at = clamp((uv - 0.5 / size) / (1.0 - 1.0 / size), 0.0, 1.0);
    float longest = level_of(top, radius), a = at.y * longest, height = a * a / (radius + sqrt(radius * radius + a * a));
    float way = mix(top - height, a + longest, at.x);
    if (way <= 0.0) return vec2(height, 1.0);
    float up = ((top - height) * (2.0 * radius + top + height) / way - way) / (2.0 * (radius + height));
    return vec2(height, clamp(up, -1.0, 1.0));
}
