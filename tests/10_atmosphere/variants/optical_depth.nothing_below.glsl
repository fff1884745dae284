// wrong: optical_depth(
float chapman(float x) {
    return x <= 8.0 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + x * (1.7245609 + x)) : 0.56498823 / (0.06651874 + x);
}

float upwards(float height, float slope, float radius, float scale_height) {
    float ratio = (radius + height) / scale_height;
    return scale_height * exp(-height / scale_height) * sqrt(0.5 * 3.14159265 * ratio) * chapman(sqrt(0.5 * ratio) * slope);
}

float optical_depth(float height, float slope, float radius, float scale_height) {
    if (scale_height <= 0.0) return 0.0;
    if (slope >= 0.0) return upwards(height, slope, radius, scale_height);
    // r - r sin = r cos² / (1 + sin)
    float down = (radius + height) * slope * slope / (1.0 + sqrt(max(1.0 - slope * slope, 0.0)));
    float lowest = height - down;
    if (lowest < 0.0) return 0.0;
    return max(2.0 * upwards(lowest, 0.0, radius, scale_height) - upwards(height, -slope, radius, scale_height), 0.0);
}
