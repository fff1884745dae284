// Solution of 10.height_fog.
float height_fog(float density, float falloff, float y, float slope, float distance) {
    float climb = falloff * slope * distance;
    float lower = min(falloff * y, falloff * y + climb), x = abs(climb);
    float mean = x < 0.1 ? 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0))) : (1.0 - exp(-x)) / x;
    return density * exp(min(-lower, 80.0)) * distance * mean;
}
