// wrong: beckmann(
float beckmann(float n_dot_h, float m) {
    if (n_dot_h < 0.05) return 0.0;
    float c2 = min(n_dot_h * n_dot_h, 1.0);
    return exp((c2 - 1.0) / (c2 * m * m)) / (m * m * c2 * c2);
}
