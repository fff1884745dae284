// wrong: range_fade(
float range_fade(float distance, float range, float k) {
    if (distance >= range) return 0.0;
    return (1.0 - distance / range) / (1.0 + k * distance * distance);
}
