// wrong: divides
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    float b = (radius + height) * slope, c = (height - shell) * (2.0 * radius + height + shell), d = b * b - c;
    if (d < 0.0) return vec2(1.0, -1.0);
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(d));
    return vec2(min(q, c / q), max(q, c / q));
}
