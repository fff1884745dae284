// wrong: height_fog(density = 0.001, falloff = 0.01, y = 20000
float height_fog(float density, float falloff, float y, float slope, float distance) {
    float x = falloff * slope * distance;
    return density * exp(-falloff * y) * distance * (abs(x) < 0.02 ? 1.0 - x / 2.0 + x * x / 6.0 : (1.0 - exp(-x)) / x);
}
