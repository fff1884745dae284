// wrong: table_uv(height =
float level(float h, float r) { return sqrt(max(h * (2.0 * r + h), 0.0)); }
vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    float b = (radius + height) * slope, c = (height - top) * (2.0 * radius + height + top);
    float way = sqrt(max(b * b - c, 0.0)) - b, least = top - height, most = level(height, radius) + level(top, radius);
    return vec2(most > least ? (way - least) / (most - least) : 0.0, level(height, radius) / level(top, radius));
}
vec2 table_place(vec2 uv, float radius, float top, vec2 size) { return vec2(uv.y * top, uv.x); }
