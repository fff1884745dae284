// wrong: divides
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    float t = clamp((cosine - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    return pow(t, mix(1.0, 0.35, softness));
}
