// wrong: takes smoothstep between
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    return pow(smoothstep(cos_outer, cos_inner, cosine), mix(1.0, 0.35, softness));
}
