// wrong: inverse_square_window(
float inverse_square_window(float distance, float range) {
    if (distance >= range) return 0.0;
    return (1.0 - pow(distance / range, 4.0)) / (distance * distance + 1.0);
}
