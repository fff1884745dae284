// right
float phase_mie(float c, float g) {
    float s = g < 0.0 ? (1.0 + g) * (1.0 + g) - 2.0 * g * (1.0 + c) : (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - c);
    return 1.5 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + c * c) * pow(s, -1.5) / 12.566370614;
}
