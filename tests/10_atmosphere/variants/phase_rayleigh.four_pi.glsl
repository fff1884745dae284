// right
float phase_rayleigh(float cos_angle) { return 0.75 * (1.0 + cos_angle * cos_angle) / (4.0 * 3.14159265358979); }
