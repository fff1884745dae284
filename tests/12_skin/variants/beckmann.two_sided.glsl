// wrong: beckmann(
float beckmann(float n_dot_h, float m) {
    float c2 = min(n_dot_h * n_dot_h, 1.0);
    if (c2 < 0.0025) return 0.0;
    return exp((c2 - 1.0) / (c2 * m * m)) / (3.14159265 * m * m * c2 * c2);
}
