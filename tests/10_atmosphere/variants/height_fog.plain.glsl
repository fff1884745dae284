// wrong: divides
float height_fog(float density, float falloff, float y, float slope, float distance) {
    float x = falloff * slope * distance;
    return density * exp(-falloff * y) * distance * (1.0 - exp(-x)) / x;
}
