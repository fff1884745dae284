// right
float phase_mie(float c, float g) {
    float s = max(1.0 + g * g - 2.0 * g * c, 1e-6);
    return 1.5 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + c * c) * pow(s, -1.5) / 12.566370614;
}
