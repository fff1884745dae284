// right
const float half_pi = 1.57079633;
float level(float h, float r, float H) { return H * exp(-h / H) * sqrt(half_pi * (r + h) / H) * (1.0606963 / 1.0619896); }
float optical_depth(float height, float slope, float radius, float scale_height) {
    if (scale_height == 0.0) return 0.0;
    float X = (radius + height) / scale_height, x = sqrt(0.5 * X) * abs(slope);
    float s = 0.56498823 / (0.06651874 + x);
    if (x <= 8.0) s = (0.55643831 * x + 1.0606963) / ((x + 1.7245609) * x + 1.0619896);
    float up = scale_height * exp(-height / scale_height) * sqrt(half_pi * X) * s;
    if (slope >= 0.0) return up;
    float rise = (radius + height) * slope * slope / (1.0 + sqrt(1.0 - slope * slope));
    return 2.0 * level(max(0.0, height - rise), radius, scale_height) - up;
}
