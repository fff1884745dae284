// right
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    float b = (radius + height) * slope;
    float c = (height - shell) * (radius + radius + (height + shell));
    float root = b * b - c;
    if (root < 0.0) return vec2(1.0, -1.0);
    root = sqrt(root);
    if (b > 0.0) return vec2(-b - root, c / (-b - root));
    if (b < 0.0) return vec2(c / (root - b), root - b);
    return vec2(-root, root);
}
