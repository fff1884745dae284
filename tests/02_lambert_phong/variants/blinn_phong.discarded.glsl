// right
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    // What normalize gives for a sum of 0 is thrown away.
    vec3 sum = to_light + to_eye, half_vector = normalize(sum);
    if (dot(sum, sum) < 1e-12 || dot(normal, to_light) <= 0.0) return 0.0;
    float cosine = min(dot(normal, half_vector), 1.0);
    return cosine <= 0.0 ? 0.0 : pow(cosine, shininess);
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
