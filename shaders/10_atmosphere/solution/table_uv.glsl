// Solution of 10.table_uv. The mapping: E. Bruneton and F. Neyret, Computer Graphics Forum 27(4), 2008, section 4; texels as
// in Bruneton's implementation of 2017.
float to_texel_middles(float x, float size) { return (0.5 + clamp(x, 0.0, 1.0) * (size - 1.0)) / size; }
float from_texel_middles(float u, float size) { return clamp((u * size - 0.5) / (size - 1.0), 0.0, 1.0); }

float way_to_ground_level(float height, float radius) { return sqrt(max(height * (2.0 * radius + height), 0.0)); }

vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    float level = way_to_ground_level(height, radius), longest = way_to_ground_level(top, radius);
    float b = (radius + height) * slope, c = (height - top) * (2.0 * radius + height + top);  // below 0
    float root = sqrt(max(b * b - c, 0.0));
    float way = b > 0.0 ? -c / (b + root) : root - b;
    float least = top - height, most = level + longest;
    float x = most > least ? (way - least) / (most - least) : 0.0;
    return vec2(to_texel_middles(x, size.x), to_texel_middles(level / longest, size.y));
}

vec2 table_place(vec2 uv, float radius, float top, vec2 size) {
    float longest = way_to_ground_level(top, radius), level = from_texel_middles(uv.y, size.y) * longest;
    float height = level * level / (radius + sqrt(radius * radius + level * level));
    float least = top - height, most = level + longest;
    float way = least + from_texel_middles(uv.x, size.x) * (most - least);
    // way² + 2 r way slope = (top - height)(2 radius + top + height)
    float slope = way > 0.0 ? ((top - height) * (2.0 * radius + top + height) - way * way) / (2.0 * (radius + height) * way) : 1.0;
    return vec2(height, clamp(slope, -1.0, 1.0));
}
