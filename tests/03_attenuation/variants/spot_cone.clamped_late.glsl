// wrong: takes pow(-
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    float t = (cosine - cos_outer) / max(cos_inner - cos_outer, 1e-6);
    return clamp(pow(t, mix(1.0, 0.35, softness)), 0.0, 1.0);
}
