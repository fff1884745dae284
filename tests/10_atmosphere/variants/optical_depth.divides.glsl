// wrong: divides
float up(float height, float slope, float radius, float H) {
    float X = (radius + height) / H, x = sqrt(max(0.5 * X, 0.0)) * slope;
    float s = x <= 8.0 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + 1.7245609 * x + x * x) : 0.56498823 / (0.06651874 + x);
    return H * exp(-height / H) * sqrt(1.57079633 * max(X, 0.0)) * s;
}
float optical_depth(float height, float slope, float radius, float H) {
    if (slope >= 0.0) return up(height, slope, radius, H);
    float lowest = max(height - (radius + height) * slope * slope / (1.0 + sqrt(1.0 - slope * slope)), 0.0);
    return 2.0 * up(lowest, 0.0, radius, H) - up(height, -slope, radius, H);
}
