// right
float range_fade(float distance, float range, float k) {
    if (range <= 0.0 || distance >= range) return 0.0;
    float left = (range - distance) / range;
    return pow(left, 2.0) / fma(k * distance, distance, 1.0);
}
