// right
float inverse_square_window(float distance, float range) {
    if (distance >= range) return 0.0;
    float window = clamp(1.0 - pow(distance / range, 4.0), 0.0, 1.0);
    return window * window / (distance * distance + 1.0);
}
