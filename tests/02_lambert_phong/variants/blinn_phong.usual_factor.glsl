// wrong: blinn_phong_normalisation(
float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 sum = to_light + to_eye;
    if (dot(normal, to_light) <= 0.0 || dot(normal, sum) <= 0.0 || dot(sum, sum) < 1e-12) return 0.0;
    return pow(min(dot(normal, normalize(sum)), 1.0), shininess);
}

float blinn_phong_normalisation(float shininess) {
    return (shininess + 8.0) / 8.0;
}
