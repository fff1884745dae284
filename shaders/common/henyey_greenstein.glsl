// Henyey–Greenstein phase function (Astrophysical Journal 93, 1941, p. 77) with mean cosine g. `mean`: average over all
// directions; 1 / (4 pi) gives shares per steradian.
float henyey_greenstein(float cosine, float g, float mean) {
    float b = 1.0 + g * g - 2.0 * g * cosine;
    return mean * (1.0 - g * g) / (b * sqrt(b));
}
