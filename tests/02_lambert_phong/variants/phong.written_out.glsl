// right
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    float facing = dot(normal, to_light);
    if (!(facing > 0.0)) return 0.0;
    vec3 mirrored = 2.0 * facing * normal - to_light;
    float cosine = clamp(dot(mirrored, to_eye), 0.0, 1.0);
    if (cosine == 0.0) return 0.0;
    return pow(cosine, shininess);
}
