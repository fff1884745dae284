// wrong: divides 0 by 0
float inverse_square_window(float distance, float range) {
    if (distance > range) return 0.0;
    float share = distance / range, square = share * share, window = max(1.0 - square * square, 0.0);
    return window * window / (distance * distance + 1.0);
}
