// right
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    if (cosine <= cos_outer) return 0.0;
    if (cosine >= cos_inner) return 1.0;
    float t = (cosine - cos_outer) / (cos_inner - cos_outer);
    return pow(t, mix(1.0, 0.35, softness));
}
