// wrong: table_uv(height =
vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    float r = radius + height, t = radius + top, longest = sqrt(t * t - radius * radius), level = sqrt(max(r * r - radius * radius, 0.0));
    float way = sqrt(max(r * r * (slope * slope - 1.0) + t * t, 0.0)) - r * slope, least = top - height, most = level + longest;
    return (0.5 + clamp(vec2((way - least) / max(most - least, 1e-3), level / longest), 0.0, 1.0) * (size - 1.0)) / size;
}
vec2 table_place(vec2 uv, float radius, float top, vec2 size) {
    vec2 at = clamp((uv * size - 0.5) / (size - 1.0), 0.0, 1.0);
    float t = radius + top, longest = sqrt(t * t - radius * radius), level = at.y * longest, r = sqrt(radius * radius + level * level);
    float way = t - r + at.x * (level + longest - t + r);
    return vec2(r - radius, way > 0.0 ? clamp((longest * longest - level * level - way * way) / (2.0 * r * way), -1.0, 1.0) : 1.0);
}
