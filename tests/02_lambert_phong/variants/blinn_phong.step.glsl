// wrong: inversesqrt(0)
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 sum = to_light + to_eye;
    float cosine = max(dot(normal, sum) * inversesqrt(dot(sum, sum)), 0.0);
    if (cosine == 0.0) return 0.0;
    return step(1e-9, dot(normal, to_light)) * pow(min(cosine, 1.0), shininess);
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
