// Solution of 03.range_fade.

float range_fade(float distance, float range, float k) {
    if (distance >= range) return 0.0;  // so range is above 0 below
    float left = 1.0 - distance / range;
    return left * left / (1.0 + k * distance * distance);
}
