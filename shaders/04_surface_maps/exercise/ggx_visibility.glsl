// Exercise 04.ggx_visibility: the mirrors that neither the light nor the camera loses behind others.
// Starter: no mirror hides another; where the light grazes, surfaces are far too bright.

// [ggx_visibility]
// V = G / (4 (N·L) (N·V)) of a surface of the roughness `alpha`, above 0 to 1. The share of
// mirrors that both sides see is G = 1 / (1 + Λ(N·L) + Λ(N·V)), for a cosine c with
//     Λ(c) = (sqrt(1 + alpha² tan²) - 1) / 2, where tan² = (1 - c²) / c².
// Returns V, which has no unit. Both cosines are 0 to 1, and one of them may be exactly 0: V is
// finite there.
// [/ggx_visibility]
float ggx_visibility(float n_dot_l, float n_dot_v, float alpha) {
    return 0.25 / max(n_dot_l * n_dot_v, 1e-20);
}
