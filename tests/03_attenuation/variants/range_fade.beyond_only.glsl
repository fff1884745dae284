// wrong: divides 0 by 0
float range_fade(float distance, float range, float k) {
    if (distance > range) return 0.0;
    float left = 1.0 - distance / range;
    return left * left / (1.0 + k * distance * distance);
}
