// wrong: divides 0 by 0
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 sum = to_light + to_eye;
    float cosine = min(dot(normal, sum / length(sum)), 1.0);
    if (dot(normal, to_light) <= 0.0 || cosine <= 0.0) return 0.0;
    return pow(cosine, shininess);
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
