// wrong: normalizes a vector of length 0
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 half_vector = normalize(to_light + to_eye);
    float cosine = dot(normal, half_vector);
    return dot(normal, to_light) > 0.0 && cosine > 0.0 ? pow(min(cosine, 1.0), shininess) : 0.0;
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
