// right
float range_fade(float distance, float range, float k) {
    float left = 1.0 - distance / range;  // at range 0 it counts for nothing
    return distance < range ? left * left / (1.0 + k * distance * distance) : 0.0;
}
