// wrong: ray_sphere(height =
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    float r = radius + height, s = radius + shell, b = r * slope, d = b * b - (r * r - s * s);
    if (d < 0.0) return vec2(1.0, -1.0);
    return vec2(-b - sqrt(d), -b + sqrt(d));
}
