// wrong: phase_mie(cos_angle =
float phase_mie(float c, float g) {
    float s = 1.0 + g * g - 2.0 * g * c;
    return (1.0 - g * g) / (s * sqrt(s)) / 12.566370614;
}
