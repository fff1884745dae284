// right
float optical_depth(float height, float slope, float radius, float H) {
    if (H <= 0.0) return 0.0;
    float sum = 0.0, where[2] = float[2](height, height), toward[2] = float[2](abs(slope), 0.0);
    if (slope < 0.0) where[1] = max(0.0, height - (radius + height) * slope * slope / (1.0 + sqrt(max(0.0, 1.0 - slope * slope))));
    for (int i = 0; i < 2; ++i) {
        float X = (radius + where[i]) / H, x = sqrt(X / 2.0) * toward[i];
        float s = x <= 8.0 ? (1.0606963 + 0.55643831 * x) / (1.0619896 + 1.7245609 * x + x * x) : 0.56498823 / (0.06651874 + x);
        float d = H * exp(-where[i] / H) * sqrt(1.5707963 * X) * s;
        if (slope >= 0.0 && i == 0) sum = d;
        if (slope < 0.0) sum += i == 0 ? -d : 2.0 * d;
    }
    return sum;
}
