// wrong: wrapped_diffuse(
float wrapped_diffuse(float cosine, float wrap, float power) {
    return pow(clamp(cosine + wrap, 0.0, 1.0), power);
}

vec3 wrapped_tint(float cosine, vec3 tint) {
    return mix(tint, vec3(1.0), clamp(cosine, 0.0, 1.0));
}
