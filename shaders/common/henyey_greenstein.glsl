// Henyey–Greenstein phase function (Astrophysical Journal 93, 1941, p. 77) with mean cosine g. `mean`: average over all
// directions; 1 / (4 pi) gives shares per steradian.
float henyey_greenstein(float cosine, float g, float mean) {
    float b = 1.0 + g * g - 2.0 * g * cosine;
    return mean * (1.0 - g * g) / (b * sqrt(b));
}

// Cosine of a scattering angle drawn from it, for `x` uniform from -1 to 1: the inverse of its integral.
float henyey_greenstein_cosine(float g, float x) {
    if (abs(g) <= 1e-3) return x;
    float b = (1.0 - g * g) / (1.0 + g * x);
    return clamp((1.0 + g * g - b * b) / (2.0 * g), -1.0, 1.0);
}
