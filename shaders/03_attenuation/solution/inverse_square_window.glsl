// Solution of 03.inverse_square_window (B. Karis, Real Shading in Unreal Engine 4, SIGGRAPH course, 2013).

float inverse_square_window(float distance, float range) {
    if (distance >= range) return 0.0;  // so range is above 0 below
    float share = distance / range;
    float window = 1.0 - share * share * share * share;
    return window * window / (distance * distance + 1.0);
}
