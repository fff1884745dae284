// wrong: slope = -
float optical_depth(float height, float slope, float radius, float H) {
    if (H <= 0.0) return 0.0;
    float X = (radius + height) / H, x = sqrt(0.5 * X) * slope;
    float s = x <= 8.0 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + 1.7245609 * x + x * x) : 0.56498823 / (0.06651874 + x);
    return H * exp(-height / H) * sqrt(1.57079633 * X) * s;
}
