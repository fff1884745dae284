// right
float height_fog(float density, float falloff, float y, float slope, float distance) {
    float a = falloff * y, b = falloff * (y + slope * distance), x = falloff * slope * distance;
    if (abs(x) < 0.05) return density * distance * exp(-a) * (1.0 - x / 2.0 + x * x / 6.0 - x * x * x / 24.0);
    return density * distance * (exp(-a) - exp(-b)) / x;
}
