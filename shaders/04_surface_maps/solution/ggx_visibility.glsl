// Solution of 04.ggx_visibility (E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2),
// 2014, equation 99).
float ggx_visibility(float n_dot_l, float n_dot_v, float alpha) {
    float square = alpha * alpha;
    float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - square) + square);
    float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - square) + square);
    return 0.5 / max(l + v, 1e-20);
}
