// wrong: divides

float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    // Of cosines near 1 a float tells 6e-8 apart; a narrower edge is a hard one.
    if (cosine < cos_outer) return 0.0;
    float t = clamp((cosine - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    return pow(t, mix(1.0, 0.35, softness));
}
