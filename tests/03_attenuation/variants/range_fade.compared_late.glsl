// wrong: divides 0 by 0
float range_fade(float distance, float range, float k) {
    float left = 1.0 - distance / range;
    if (left <= 0.0) return 0.0;
    return left * left / (1.0 + k * distance * distance);
}
