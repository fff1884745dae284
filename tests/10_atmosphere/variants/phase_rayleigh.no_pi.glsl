// wrong: phase_rayleigh(cos_angle =
float phase_rayleigh(float cos_angle) { return 0.75 * (1.0 + cos_angle * cos_angle); }
