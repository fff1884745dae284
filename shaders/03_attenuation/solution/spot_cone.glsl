// Solution of 03.spot_cone.

float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    // Floats near 1 are 6e-8 apart; a narrower edge is treated as a hard one.
    float t = clamp((cosine - cos_outer) / max(cos_inner - cos_outer, 1e-7), 0.0, 1.0);
    return pow(t, mix(1.0, 0.35, softness));
}
