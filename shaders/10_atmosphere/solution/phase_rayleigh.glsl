// Solution of 10.phase_rayleigh. Lord Rayleigh, Philosophical Magazine 41, 1871.
float phase_rayleigh(float cos_angle) { return 3.0 / (16.0 * 3.14159265) * (1.0 + cos_angle * cos_angle); }
