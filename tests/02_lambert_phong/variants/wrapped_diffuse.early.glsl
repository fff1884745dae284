// right
float wrapped_diffuse(float cosine, float wrap, float power) {
    if (cosine <= -wrap) return 0.0;
    return exp2(power * log2((cosine + wrap) / (1.0 + wrap)));
}

vec3 wrapped_tint(float cosine, vec3 tint) {
    return mix(tint, vec3(1.0), clamp(cosine, 0.0, 1.0));
}
