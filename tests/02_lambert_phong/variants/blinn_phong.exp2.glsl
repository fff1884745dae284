// right
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 sum = to_light + to_eye;
    float along = dot(normal, sum), across = dot(sum, sum);
    if (dot(normal, to_light) <= 0.0 || along <= 0.0 || across < 1e-12) return 0.0;
    return exp2(shininess * min(log2(along / sqrt(across)), 0.0));
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
