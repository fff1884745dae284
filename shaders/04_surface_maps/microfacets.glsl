// Microfacets: GGX with the height-correlated masking of Smith.
#include "common/schlick.glsl"

const float pi = 3.14159265358979;

// T. Trowbridge and K. Reitz, 1975; B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007,
// equation 33. Per steradian of half vectors.
float ggx_density(float n_dot_h, float alpha) {
    float square = alpha * alpha, c = n_dot_h * n_dot_h;
    float d = c * square + (1.0 - c);  // c (square - 1) + 1 loses its digits where c is nearly 1
    return square / max(pi * d * d, 1e-30);
}

// Masking and shadowing over 4 n·l n·v: E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
// JCGT 3(2), 2014, equation 99. n_dot_l and n_dot_v are above 0.
float ggx_visibility(float n_dot_l, float n_dot_v, float alpha) {
    float square = alpha * alpha;
    float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - square) + square);
    float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - square) + square);
    return 0.5 / max(l + v, 1e-20);
}
