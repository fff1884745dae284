// wrong: but a hard edge is 0 or 1
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    if (cosine > cos_inner) return 1.0;
    if (cosine < cos_outer) return 0.0;
    if (cos_inner == cos_outer) return 0.5;
    return pow((cosine - cos_outer) / (cos_inner - cos_outer), 1.0 - 0.65 * softness);
}
