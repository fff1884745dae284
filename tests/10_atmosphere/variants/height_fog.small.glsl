// wrong: height_fog(density =
float height_fog(float density, float falloff, float y, float slope, float distance) {
    float x = falloff * slope * distance;
    return density * exp(-falloff * y) * distance * (abs(x) < 1e-7 ? 1.0 : (1.0 - exp(-x)) / x);
}
