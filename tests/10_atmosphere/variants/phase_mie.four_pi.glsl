// wrong: phase_mie(cos_angle =
float phase_mie(float c, float g) {
    float s = 1.0 + g * g - 2.0 * g * c;
    return 1.5 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + c * c) / (s * sqrt(s));
}
