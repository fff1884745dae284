// Solution of 02.blinn_phong (J. F. Blinn, Models of Light Reflection for Computer Synthesized Pictures, 1977).

float blinn_phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 between = to_light + to_eye;
    float cosine = dot(normal, between) * inversesqrt(max(dot(between, between), 1e-12));
    bool lit = dot(normal, to_light) > 0.0 && cosine > 0.0;
    return lit ? pow(min(cosine, 1.0), shininess) : 0.0;
}

// The exact integral of the lobe times the cosine over the hemisphere, camera at the zenith. The usual (n + 8) / 8
// overshoots it by up to 7.5 %.
float blinn_phong_normalisation(float shininess) {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * (exp2(-0.5 * shininess) + shininess));
}
