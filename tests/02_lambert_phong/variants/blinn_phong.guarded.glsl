// right
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    if (dot(normal, to_light) <= 0.0) return 0.0;
    vec3 sum = to_light + to_eye;
    float size = length(sum);
    if (size < 1e-6) return 0.0;
    float cosine = clamp(dot(normal, sum) / size, 0.0, 1.0);
    return cosine > 0.0 ? pow(cosine, shininess) : 0.0;
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
