// Solution of 10.phase_mie. W. M. Cornette and J. G. Shanks, Applied Optics 31(16), 1992, p. 3155.
float phase_mie(float cos_angle, float g) {
    float forward = 1.0 - cos_angle, back = 1.0 - abs(g);
    // 1 + g² - 2 g cos without cancellation where both are near 1.
    float b = g >= 0.0 ? back * back + 2.0 * g * forward : back * back - 2.0 * g * (1.0 + cos_angle);
    return 3.0 / (8.0 * 3.14159265) * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cos_angle * cos_angle) / (b * sqrt(b));
}
