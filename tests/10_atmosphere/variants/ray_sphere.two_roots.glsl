// wrong: ray_sphere(height =
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    float b = (radius + height) * slope, c = (height - shell) * (2.0 * radius + height + shell), d = b * b - c;
    if (d < 0.0) return vec2(1.0, -1.0);
    return vec2(-b - sqrt(d), -b + sqrt(d));
}
