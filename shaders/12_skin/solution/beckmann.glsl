// Solution of 12.beckmann.

float beckmann(float n_dot_h, float m) {
    // With less, even the roughest surface's exponential is below every float.
    if (n_dot_h < 0.05) return 0.0;
    float c2 = min(n_dot_h * n_dot_h, 1.0), m2 = m * m;
    return exp((c2 - 1.0) / (c2 * m2)) / (3.14159265 * m2 * c2 * c2);
}
