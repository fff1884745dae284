// Solution of 10.ray_sphere. The roots' formula without cancellation: W. H. Press et al., "Numerical recipes", section 5.6.
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    float b = (radius + height) * slope, c = (height - shell) * (2.0 * radius + height + shell);
    float discriminant = b * b - c;
    if (discriminant < 0.0) return vec2(1.0, -1.0);
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float other = q == 0.0 ? 0.0 : c / q;
    return vec2(min(q, other), max(q, other));
}
