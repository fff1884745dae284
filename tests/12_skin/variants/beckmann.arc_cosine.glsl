// right
float beckmann(float n_dot_h, float m) {
    if (n_dot_h < 0.04) return 0.0;
    float c = min(n_dot_h, 1.0), slope = sqrt((1.0 - c) * (1.0 + c)) / (c * m);
    return exp(-slope * slope) / (3.14159265 * m * m * c * c * c * c);
}
