// Scattering by angle (L. G. Henyey and J. L. Greenstein, Astrophysical Journal 93, 1941, p. 77). Its mean cosine is g, its
// mean over all directions `mean`: 1 / (4 pi) for shares per steradian.
float henyey_greenstein(float cosine, float g, float mean) {
    float b = 1.0 + g * g - 2.0 * g * cosine;
    return mean * (1.0 - g * g) / (b * sqrt(b));
}
