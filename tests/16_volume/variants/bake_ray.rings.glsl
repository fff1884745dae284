// right
// Square rings to round ones of the same area: P. Shirley and K. Chiu, "A low distortion map between disk and square", 1997.
vec4 bake_ray(vec2 even) {
    vec2 c = 2.0 * even - 1.0;
    if (c == vec2(0.0)) return vec4(0.0, 0.0, 1.0, 1.0);
    bool wide = abs(c.x) > abs(c.y);
    float r = wide ? c.x : c.y, angle = 0.7853981634 * (wide ? c.y / c.x : 2.0 - c.x / c.y);
    return vec4(r * cos(angle), r * sin(angle), sqrt(1.0 - min(r * r, 1.0)), 1.0);
}
